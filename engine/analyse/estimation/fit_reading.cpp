#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/analyse/estimation/fit_request.hpp"
#include "engine/analyse/query/names_reading.hpp"
#include "engine/analyse/query/number.hpp"
#include "engine/analyse/query/series.hpp"
#include "engine/analyse/query/varied.hpp"
#include "engine/base/unit/meaning.hpp"

namespace stepwire::estimation {

using yaml::form;

namespace {

/// Context for reading the section `fit`.
struct FitReading : query::NamesReading {
  const diagram::Diagram& diagram;
  std::vector<FitParameter>& parameters;  ///< All parameters of the file, including those that the call sets.

  FitReading(const query::SymbolTable& names, const diagram::Diagram& diagram,
             std::vector<FitParameter>& parameters, yaml::Faults& faults)
      : query::NamesReading("fit", names, faults), diagram(diagram), parameters(parameters) {}

  bool is_swept(const std::string& name) const {
    return diagram.sweep && std::ranges::find(diagram.sweep->axes, name, &diagram::Sweep::Axis::parameter) !=
                                diagram.sweep->axes.end();
  }
};

using ParameterTable = yaml::KeyTable<FitParameter, FitReading>;

double number(const yaml::Node& node, FitParameter& parameter, const FitReading& read) {
  const auto found = query::read_number(node, read.names, read.subject, read.faults);
  if (!found) return 0.0;
  query::check_dimension(*found, {parameter.dimension}, "the parameter", node, read.names, read.subject,
                         read.faults);
  if (!parameter.dimension) parameter.dimension = found->dimension;
  if (parameter.unit.empty()) parameter.unit = found->unit;
  if (auto wrong = query::bare_number(node.text, parameter.unit, "the parameter"))
    read.fault(node.mark, std::move(*wrong));
  return found->value;
}

void read_bounds(FitParameter& parameter, const yaml::Node& node, const FitReading& read) {
  if (!node.is_list() || node.items.size() != 2)
    return read.fault(node.mark, "bounds are a lower and an upper one: [1 kg, 5 kg]");
  parameter.lower = number(node.items[0], parameter, read);
  parameter.upper = number(node.items[1], parameter, read);
  if (!(parameter.lower < parameter.upper))
    read.fault(node.mark, fmt::format("the bounds are the wrong way round: {} is not below {}",
                                      node.items[0].text, node.items[1].text));
}

void read_scale(FitParameter& parameter, const yaml::Node& node, const FitReading& read) {
  FitParameter change = parameter;
  if (change.dimension && unit::is_temperature(*change.dimension)) change.dimension->zeros = 0.0;
  parameter.scale = number(node, change, read);
  if (!parameter.dimension) parameter.dimension = change.dimension;
  parameter.unit = change.unit;
  if (!(parameter.scale > 0.0)) read.fault(node.mark, fmt::format("the scale {} is not above 0", node.text));
}

const ParameterTable& parameter_table() {
  static const ParameterTable table(
      "it", "{start: 2 kg, bounds: [1 kg, 5 kg]}",
      {{"start", "where the search begins; the file's value without it", form::computed(),
        [](FitParameter& parameter, const yaml::Node& node, const FitReading& read) {
          parameter.start = number(node, parameter, read);
        }},
       {"bounds", "it is sought between these: [1 kg, 5 kg]", form::pair(form::computed()), read_bounds},
       {"scale", "a change that counts; the size of the start without it", form::computed(), read_scale},
       {"each_record", "true: each record has its own value, else they share one", form::truth(),
        &FitParameter::each_record}});
  return table;
}

/// Sets the defaults of a parameter and checks that its start is within its bounds.
void complete(FitParameter& parameter, const yaml::Node& node, const std::string& start,
              const FitReading& read) {
  const bool ordered = parameter.lower < parameter.upper;
  if (ordered && (parameter.start < parameter.lower || parameter.start > parameter.upper)) {
    const yaml::Node& bounds = *node.find("bounds");
    yaml::below(read, "bounds")
        .fault(bounds.mark,
               fmt::format("the start, {}, is outside of the bounds [{}, {}]; it must lie within them", start,
                           bounds.items[0].text, bounds.items[1].text));
  }
  if (node.find("scale")) return;
  if (parameter.start != 0.0)
    parameter.scale = std::abs(parameter.start);
  else if (parameter.bounded())
    parameter.scale = 0.1 * (parameter.upper - parameter.lower);
}

yaml::Message unknown(const std::string& name, const diagram::Diagram& diagram) {
  std::vector<std::string> all;
  for (const diagram::DiagramParameter& one : diagram.parameters)
    if (std::holds_alternative<double>(one.value.content)) all.push_back(one.name);
  return fmt::format("there is no parameter '{}'", name) + yaml::nearest_or_all(name, all, "there are");
}

void read_parameter(FitRequest& request, const yaml::Entry& entry, const FitReading& read) {
  const auto of = std::ranges::find(read.diagram.parameters, entry.key, &diagram::DiagramParameter::name);
  if (of == read.diagram.parameters.end()) return read.fault(entry.mark, unknown(entry.key, read.diagram));
  const double* own = std::get_if<double>(&of->value.content);
  if (!own)
    return read.fault(entry.mark, fmt::format("'{}' is no single number, which alone is fitted", of->text));
  if (read.is_swept(entry.key))
    return read.fault(entry.mark, "is swept, so it is given; take it out of 'sweep' or out of 'fit'");
  FitParameter parameter{.name = entry.key, .start = *own, .dimension = of->dimension};
  parameter.place = {read.names.file, entry.mark};
  if (!parameter_table().read(entry.value, parameter, read)) return;
  const yaml::Node* start = entry.value.find("start");
  complete(parameter, entry.value, start ? start->text : of->text, read);
  read.parameters.push_back(parameter);
  if (!of->set) request.parameters.push_back(std::move(parameter));  // the call sets a fixed value
}

const yaml::Key& fit_parameter_form() {
  return parameter_table().form;
}

void read_fit_parameters(FitRequest& request, const yaml::Node& node, const FitReading& read) {
  if (!node.is_map() || node.entries.empty())
    return read.fault(node.mark,
                      "names what is to be found: {rig.mass: {start: 2 kg, bounds: [1 kg, 5 kg]}}");
  for (const yaml::Entry& entry : node.entries) read_parameter(request, entry, yaml::below(read, entry.key));
}

/// Marks the parameters that a fit changes, and those that follow from them.
void mark_fitted(const std::vector<FitParameter>& parameters, const diagram::Diagram& diagram,
                 query::SymbolTable& names) {
  query::VariedNames fitted{{}, "found by the fit"};
  for (const FitParameter& parameter : parameters) fitted.names.push_back(parameter.name);
  query::mark_varied(diagram, fitted, names);
}

const char* const subject = "fit.curves";
const char* const over_form = "'over' names the variable and its range in bare numbers: {i: [0, 1]}";

/// Returns the names for a curve's expression: the parameters that all records share, and the variable.
query::SymbolTable names_in_curve(const FitReading& read, const std::string& variable) {
  query::SymbolTable known{read.names.file,
                           {{variable, unit::Dimension{}, {}}},
                           read.names.parameters,
                           {},
                           "is neither the variable nor a fitted parameter that all records share"};
  for (const FitParameter& parameter : read.parameters)
    if (!parameter.each_record) known.columns.push_back({parameter.name, parameter.dimension, {}});
  mark_fitted(read.parameters, read.diagram, known);
  return known;
}

/// Returns the start values of these parameters; 0 for the variable.
std::vector<double> starts_of(const std::vector<std::string>& columns,
                              const std::vector<FitParameter>& parameters) {
  std::vector<double> starts(columns.size(), 0.0);
  for (std::size_t i = 0; i < columns.size(); ++i)
    for (const FitParameter& parameter : parameters)
      if (parameter.name == columns[i]) starts[i] = parameter.start;
  return starts;
}

const yaml::Key& fit_curve_form() {
  yaml::Key over = form::names(form::pair(form::computed()), 1);
  over.most = 1;
  static const yaml::Key form = form::keys(
      "a curve", "{y: c1*i + c0, over: {i: [0, 1]}, data: current}",
      {yaml::needed(yaml::key("y", "expression of fitted parameters and of the variable", form::series())),
       yaml::needed(yaml::key("over", "the variable and its range in bare numbers: {i: [0, 1]}", over)),
       yaml::key("data", "where the records have the variable; this range is shaded", form::expression()),
       yaml::key("x_label", "text at the axis of the variable")});
  return form;
}

class CurveReader {
 public:
  CurveReader(const yaml::Node& node, const FitReading& fit)
      : node_(node), fit_(fit), names_(fit.names), faults_(fit.faults) {}

  std::optional<FitCurve> read() {
    if (!query::NamesReading(subject, names_, faults_).check(node_, fit_curve_form())) return std::nullopt;
    const yaml::Node *over = node_.find("over"), *y = node_.find("y");
    if (!over || !y) return std::nullopt;
    if (!over->is_map() || over->entries.size() != 1) return refused(*over, over_form);
    const yaml::Entry& variable = over->entries.front();
    const auto range = read_range(variable.value);
    auto series = query::read_series(*y, names_in_curve(fit_, variable.key), subject, faults_);
    if (!series || !range) return std::nullopt;
    std::vector<double> otherwise = starts_of(series->formula.columns, fit_.parameters);
    FitCurve curve{std::move(*series), std::move(otherwise), variable.key, range->first,
                   range->second,      variable.key,         {},           0};
    curve.place = {names_.file, node_.mark};
    read_data(curve);
    if (const yaml::Node* label = node_.find("x_label"))
      curve.label = query::read_text(*label, names_, "fit.curves.x_label", faults_);
    return curve;
  }

 private:
  std::nullopt_t refused(const yaml::Node& at, const std::string& message) {
    faults_.add({{names_.file, at.mark}, subject, message, {}});
    return std::nullopt;
  }

  std::optional<std::pair<double, double>> read_range(const yaml::Node& range) {
    if (!range.is_list() || range.items.size() != 2) return refused(range, over_form);
    const auto from = query::read_number(range.items[0], names_, subject, faults_);
    const auto to = query::read_number(range.items[1], names_, subject, faults_);
    if (!from || !to) return std::nullopt;
    if (from->value < to->value) return std::pair{from->value, to->value};
    return refused(range, "the first number of a range is below the second");
  }

  void read_data(FitCurve& curve) {
    const yaml::Node* data = node_.find("data");
    if (!data) return;
    curve.data = query::read_formula(*data, names_, "fit.curves.data", faults_);
    if (curve.data)
      curve.recording = query::common_recording({&*curve.data}, names_, *data, "fit.curves.data", faults_);
  }

  const yaml::Node& node_;
  const FitReading& fit_;
  const query::SymbolTable& names_;
  yaml::Faults& faults_;
};

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
  query::SymbolTable names = read.names;
  mark_fitted(request.parameters, read.diagram, names);
  FitReading marked(names, read.diagram, read.parameters, read.faults);
  marked.subject = read.subject;
  for (const yaml::Node& item : list.items) read_comparison(request, item, marked);
}

void read_curves(FitRequest& request, const yaml::Node& list, const FitReading& read) {
  if (!list.is_list())
    return read.fault(list.mark, "is a list: [{y: c1*i + c0, over: {i: [0, 1]}, data: current}]");
  for (const yaml::Node& item : list.items)
    if (auto curve = CurveReader(item, read).read()) request.curves.push_back(std::move(*curve));
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
