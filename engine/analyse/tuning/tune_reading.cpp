#include <fmt/format.h>

#include <algorithm>

#include "engine/analyse/query/varied.hpp"
#include "engine/analyse/tuning/constraint.hpp"
#include "engine/analyse/tuning/tune_keys.hpp"

namespace stepwire::tuning {

using yaml::form;

namespace {

using TuneTable = yaml::KeyTable<TuneRequest, TuneReading>;
using claim::Reduction;

TuneTable::Row parameters_row() {
  return {"parameters", "what is tuned, by the names that --set takes",
          yaml::like("{rig.kp: {from: 0.1, to: 10, start: 1}}",
                     form::naming(yaml::Key::Names::parameter, form::names(tune_parameter_form(), 1))),
          read_tune_parameters};
}

TuneTable::Row minimise_row() {
  return {"minimise",
          "what is made as small as can be: an expression of reductions, with the names that claims have for "
          "them: settling_time(y)/(1 s) + 0.1*rms(u where time > 1 s)",
          form::expression()};
}

TuneTable::Row method_row() {
  return {
      "method", "of the search",
      form::words(
          {{"auto",
            "cobyla with claims, least_squares with targets, subplex where the objective jumps, else bobyqa"},
           {"bobyqa", "for a smooth objective, without claims"},
           {"cobyla", "for claims"},
           {"isres", "all over the bounds, with claims or without, and from the best point on by cobyla"},
           {"subplex", "for an objective that jumps, without claims"},
           {"least_squares", "for targets, without claims"}}),
      &TuneRequest::method};
}

TuneTable::Row toward_row() {
  return {
      "toward",
      "in place of 'minimise': claims, each with 'equals' and 'within', the deviation that it may have; the "
      "sum of the squares of what each is off, in such deviations, is made as small as can be",
      form::list(form::section("claim"))};
}

const TuneTable& tune_table() {
  static const TuneTable table(
      "the tuning", "{parameters: {..}, minimise: ..}",
      {yaml::needed(parameters_row()),
       minimise_row(),
       toward_row(),
       {"subject_to", "claims that hold at what is found, each with a value and a bound",
        form::list(form::section("claim"))},
       {"over", "what counts of the runs of a sweep: the worst of them, or their mean",
        form::word({"worst", "mean"}), &TuneRequest::over},
       method_row(),
       {"starts", "searches; the first begins at the given start, the others within the bounds",
        form::whole(1, 10'000), &TuneRequest::starts},
       {"seed", "of what is random", form::whole(0, 1'000'000'000), &TuneRequest::seed},
       {"evaluations", "of one search, at most; each makes all runs of the sweep", form::whole(1, 10'000'000),
        &TuneRequest::evaluations},
       {"experiments", "of one evaluation of a study, in place of the study's", form::whole(1, 1'000'000),
        &TuneRequest::experiments},
       {"study_seed",
        "of these experiments, in place of the study's, so that what is found is tried on other people",
        form::whole(0, 1'000'000'000), &TuneRequest::study_seed},
       {"tolerance", "change of a parameter that no longer counts, as a share of its range",
        form::above_zero(form::computed()), &TuneRequest::tolerance}});
  return table;
}

/// Returns the names for the section: tuned parameters are columns of each run; parameters and block numbers
/// that follow from them are marked.
query::SymbolTable names_while_tuned(const query::SymbolTable& names, const diagram::Diagram& diagram,
                                     const TuneRequest& request) {
  query::SymbolTable varied = names;
  std::vector<std::string> tuned;
  for (const TuneParameter& parameter : request.parameters) {
    tuned.push_back(parameter.name);
    varied.columns.push_back({parameter.name, parameter.dimension, std::nullopt});
  }
  std::erase_if(varied.parameters, [&](const query::KnownParameter& parameter) {
    return std::ranges::find(tuned, parameter.name) != tuned.end();
  });
  query::mark_varied(diagram, {tuned, "tuned"}, varied);
  return varied;
}

void check_method(const yaml::Node& node, const TuneRequest& request, const TuneReading& read) {
  const bool without = request.method != TuneMethod::automatic && request.method != TuneMethod::cobyla &&
                       request.method != TuneMethod::isres;
  const yaml::Node* method = node.find("method");
  if (method && without && !request.constraints.empty())
    read.fault(method->mark,
               fmt::format("'{}' takes no claims; those of 'subject_to' need cobyla or isres", method->text));
  if (method && request.method == TuneMethod::least_squares && request.targets.empty())
    read.fault(method->mark, "'least_squares' is for 'toward'; 'minimise' has another objective");
}

/// True for a reduction that jumps under a small change of the run.
bool jumps(const claim::Claim& of) {
  constexpr std::array jumping{Reduction::fraction, Reduction::count, Reduction::rising,
                               Reduction::settling_time, Reduction::peak_time};
  return std::ranges::find(jumping, of.reduction) != jumping.end();
}

}  // namespace

TuneMethod TuneRequest::chosen_method() const {
  if (method != TuneMethod::automatic) return method;
  if (!constraints.empty()) return TuneMethod::cobyla;
  if (!targets.empty()) return TuneMethod::least_squares;
  return std::ranges::any_of(minimise.reductions, jumps) ? TuneMethod::subplex : TuneMethod::bobyqa;
}

std::string TuneRequest::objective_text() const {
  return targets.empty() ? minimise.text : "sum of the squares of what the targets are off";
}

std::optional<unit::Dimension> TuneRequest::objective_dimension() const {
  return targets.empty() ? minimise.formula->dimension : unit::Dimension{};
}

std::vector<const claim::Claim*> TuneRequest::claims() const {
  std::vector<const claim::Claim*> all;
  for (const auto* list : {&targets, &constraints})
    for (const claim::Claim& claim : *list) all.push_back(&claim);
  return all;
}

const yaml::Key& tune_form() {
  return tune_table().form;
}

static void read_objective(const yaml::Node& node, const query::NamesReading& read, TuneRequest& request) {
  auto objective = claim::read_run_formula(node, read);
  if (objective && objective->reductions.empty())
    read.fault(node.mark,
               yaml::fault_text("'{}' has no reduction of what a run records, such as rms(x)", node.text));
  else if (objective)
    request.minimise = std::move(*objective);
}

static void check_target(const claim::Claim& claim, const yaml::Node& node, const query::NamesReading& read) {
  if (claim.comparison.kind != claim::Comparison::Kind::equals)
    read.fault(node.mark, "is a target, which 'equals' a value 'within' the deviation that it may have");
}

/// Reads either 'minimise' or 'toward'.
static void read_aim(const yaml::Node& node, const std::vector<linear::NamedAnalysis>& linear,
                     const query::NamesReading& read, TuneRequest& request) {
  const yaml::Node *minimise = node.find("minimise"), *toward = node.find("toward");
  if (minimise && toward) return read.fault(toward->mark, "a tuning has 'minimise' or 'toward', not both");
  if (minimise) return read_objective(*minimise, yaml::below<query::NamesReading>(read, "minimise"), request);
  if (!toward) return read.fault(node.mark, "'minimise' is missing, or 'toward'");
  const auto inner = yaml::below<query::NamesReading>(read, "toward");
  request.targets = read_constraints(*toward, linear, inner);
  for (std::size_t i = 0; i < request.targets.size(); ++i)
    check_target(request.targets[i], toward->items[i], inner);
}

TuneRequest read_tune(const yaml::Node& node, const query::SymbolTable& names,
                      const diagram::Diagram& diagram, const std::vector<linear::NamedAnalysis>& linear,
                      yaml::Faults& faults) {
  TuneRequest request;
  request.place = {names.file, node.mark};
  const TuneReading read(names, diagram, faults);
  const std::size_t before = faults.size();
  if (!tune_table().read(node, request, read) || faults.size() != before) return request;
  const query::SymbolTable varied = names_while_tuned(names, diagram, request);
  const TuneReading inner(varied, diagram, faults);
  read_aim(node, linear, inner, request);
  if (const yaml::Node* claims = node.find("subject_to"))
    request.constraints =
        read_constraints(*claims, linear, yaml::below<query::NamesReading>(inner, "subject_to"));
  check_method(node, request, read);
  return request;
}

}  // namespace stepwire::tuning
