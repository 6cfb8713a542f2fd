#include <fmt/format.h>

#include "engine/analyse/estimation/fit_keys.hpp"
#include "engine/analyse/query/number.hpp"

namespace stepwire::estimation {

using yaml::form;

namespace {

using FitTable = yaml::KeyTable<FitRequest, FitReading>;

/// A comparison as read from the file; its expressions may be missing.
struct ComparisonDraft {
  std::optional<query::Series> model{};
  std::optional<query::Formula> measured{}, weight{}, where{};
  std::vector<query::Series> against{};
  bool free_offset = false;
};

using ComparisonTable = yaml::KeyTable<ComparisonDraft, FitReading>;

const ComparisonTable& comparison_table() {
  static const ComparisonTable table(
      "it", "{model: rig.x, measured: record.x}",
      {yaml::needed(ComparisonTable::Row{"model", "what the diagram computes", form::series(),
                                         &ComparisonDraft::model}),
       yaml::needed(ComparisonTable::Row{"measured", "what it is held against", form::expression(),
                                         &ComparisonDraft::measured}),
       {"weight", "factor of the difference, 1 over what is expected of it: 1/(3 N)", form::expression(),
        &ComparisonDraft::weight},
       {"where", "only rows for which this is true are compared", form::expression(),
        &ComparisonDraft::where},
       {"offset", "the mean difference of each record is no error", form::word({"free"}),
        [](ComparisonDraft& draft, const yaml::Node& node, const FitReading& read) {
          draft.free_offset = read.word(node, form::word({"free"})).has_value();
        }},
       {"against", "what pictures show it over, beside the time", form::one_or_list(form::series()),
        &ComparisonDraft::against}});
  return table;
}

void read_comparison(FitRequest& request, const yaml::Node& map, const FitReading& read) {
  ComparisonDraft draft;
  if (!comparison_table().read(map, draft, read) || !draft.model || !draft.measured) return;
  const std::string other = query::compared_fault(draft.model->formula, *draft.measured);
  if (!other.empty()) read.fault(map.mark, other);
  std::vector<const query::Formula*> together{&draft.model->formula, &*draft.measured,
                                              draft.weight ? &*draft.weight : nullptr,
                                              draft.where ? &*draft.where : nullptr};
  for (const query::Series& one : draft.against) together.push_back(&one.formula);
  const std::size_t recording = query::common_recording(together, read.names, map, read.subject, read.faults);
  request.comparisons.push_back({std::move(*draft.model),
                                 std::move(*draft.measured),
                                 std::move(draft.weight),
                                 std::move(draft.where),
                                 draft.free_offset,
                                 recording,
                                 {read.names.file, map.mark},
                                 std::move(draft.against)});
}

void read_comparisons(FitRequest& request, const yaml::Node& list, const FitReading& read) {
  if (!list.is_list() || list.items.empty())
    return read.fault(list.mark, "is a list of what is compared: [{model: rig.x, measured: record.x}]");
  for (const yaml::Node& item : list.items) read_comparison(request, item, read);
}

void read_curves(FitRequest& request, const yaml::Node& list, const FitReading& read) {
  if (!list.is_list())
    return read.fault(list.mark, "is a list: [{y: c1*i + c0, over: {i: [0, 1]}, data: current}]");
  for (const yaml::Node& item : list.items)
    if (auto curve = read_fit_curve(item, read.names, read.parameters, read.faults))
      request.curves.push_back(std::move(*curve));
}

void read_hold_out(FitRequest& request, const yaml::Node& node, const FitReading& read) {
  request.hold_out = read.formula(node);
  if (!request.hold_out) return;
  for (const std::string& column : request.hold_out->columns)
    if (!read.is_swept(column))
      read.fault(node.mark,
                 fmt::format("'{}' is no swept parameter, and only these tell whole records apart", column));
}

const yaml::KeyTable<GlobalSearch, FitReading>& global_table() {
  static const yaml::KeyTable<GlobalSearch, FitReading> table(
      "it", "{population: 40, generations: 60}",
      {{"population", "how many points there are at a time", form::whole(4, 100'000),
        &GlobalSearch::population},
       {"generations", "how often they are replaced", form::whole(1, 1'000'000),
        &GlobalSearch::generations}});
  return table;
}

void read_global(FitRequest& request, const yaml::Node& node, const FitReading& read) {
  if (!global_table().read(node, request.global.emplace(), read)) return;
  for (const FitParameter& parameter : request.parameters)
    if (!parameter.bounded())
      read.faults.add({parameter.place,
                       "fit.parameters." + parameter.name,
                       "has no bounds, between which 'global' searches; give them",
                       {}});
}

FitTable::Row parameters_row() {
  return {"parameters", "what is to be found, by the names that --set takes",
          yaml::like("{rig.mass: {start: 2 kg, bounds: [1 kg, 5 kg]}}",
                     form::naming(yaml::Key::Names::parameter, form::names(fit_parameter_form(), 1))),
          read_fit_parameters};
}

FitTable::Row compare_row() {
  return {"compare", "model and measurement, side by side",
          yaml::like("[{model: rig.x, measured: record.x}]", form::list(comparison_table().form, 1)),
          read_comparisons};
}

FitTable::Row tolerance_row() {
  return {"tolerance",
          "change of a number at which a search ends, in parts of its value or of its standard error",
          form::above_zero(form::computed()), &FitRequest::tolerance};
}

FitTable::Row standard_errors_row() {
  return {"standard_errors",
          "of independent rows, or of a time series whose residuals go together; automatic: the latter where "
          "the diagram has memory",
          form::word({"automatic", "classical", "serial"}), &FitRequest::standard_errors};
}

const FitTable& fit_table() {
  static const FitTable table(
      "the fit", "{parameters: {..}, compare: [..]}",
      {yaml::needed(parameters_row()),
       yaml::needed(compare_row()),
       {"hold_out", "of swept parameters: records that are predicted, not fitted", form::expression(),
        read_hold_out},
       {"loss", "what large differences count: all, or less beyond the width",
        form::word({"none", "huber", "cauchy"}), &FitRequest::loss},
       yaml::beside({"loss"}, FitTable::Row{"width", "of the loss, in weighted differences",
                                            form::above_zero(form::computed()), &FitRequest::width}),
       {"starts", "searches; the first begins at the given start, the others within the bounds",
        form::whole(1, 10'000), &FitRequest::starts},
       {"follow", "how many of the searches go on after the first steps; a quarter without it",
        form::whole(1, 10'000), &FitRequest::follow},
       {"seed", "of what is random", form::whole(0, 1'000'000'000), &FitRequest::seed},
       {"iterations", "steps of one search, at most", form::whole(1, 100'000), &FitRequest::iterations},
       tolerance_row(),
       standard_errors_row(),
       {"global", "differential evolution within the bounds ahead of the rest", global_table().form,
        read_global},
       {"curves", "what follows from the fitted parameters, drawn with its 95 % interval",
        form::list(fit_curve_form()), read_curves},
       {"records", "what pictures call the records: measured, simulated", form::text(),
        &FitRequest::records}});
  return table;
}

}  // namespace

const yaml::Key& fit_form() {
  return fit_table().form;
}

FitRequest read_fit(const yaml::Node& node, const query::SymbolTable& names, const diagram::Diagram& diagram,
                    yaml::Faults& faults) {
  FitRequest request;
  request.place = {names.file, node.mark};
  std::vector<FitParameter> all;
  const FitReading read(names, diagram, all, faults);
  if (!fit_table().read(node, request, read)) return request;
  const yaml::Node *width = node.find("width"), *loss = node.find("loss");
  if (width && loss && request.loss == FitLoss::none)
    yaml::below(read, "width").fault(width->mark, "goes with 'loss: huber' or cauchy");
  return request;
}

}  // namespace stepwire::estimation
