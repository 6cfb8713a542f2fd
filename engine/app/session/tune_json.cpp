// JSON and CSV of an optimisation.
#include <fmt/format.h>

#include "engine/app/session/tuning.hpp"
#include "engine/base/table/table_file.hpp"
#include "engine/base/text/characters.hpp"

namespace stepwire::session {

using json::Json;

namespace {

Json dimension_json(const std::optional<unit::Dimension>& dimension) {
  return dimension ? Json(unit::si_name(*dimension)) : Json();
}

Json tuned_json(const tuning::TunedNumber& number) {
  return Json::object()
      .set("name", number.name)
      .set("value", number.value)
      .set("unit", dimension_json(number.dimension))
      .set("start", number.start)
      .set("bounds", Json::list({number.lower, number.upper}))
      .set("interval", number.interval ? Json::list({(*number.interval)[0], (*number.interval)[1]}) : Json())
      .set("at_bound", number.at_bound);
}

/// Returns the targets with their derivatives by the parameters, in deviations per range from bound to bound.
Json tuned_targets_json(const tuning::TuneResult& result) {
  Json list = Json::list();
  const auto& jacobian = result.resolution.jacobian;
  for (std::size_t i = 0; i < result.targets.size(); ++i) {
    const tuning::TunedTarget& target = result.targets[i];
    list.push(Json::object()
                  .set("that", target.verdict.that)
                  .set("check", target.verdict.check)
                  .set("value", target.verdict.value)
                  .set("off", target.off)
                  .set("start", target.start)
                  .set("derivatives", i < jacobian.size() ? Json::list_of(jacobian[i]) : Json::list()));
  }
  return list;
}

Json tuned_claims_json(const tuning::TuneResult& result) {
  Json list = Json::list();
  for (const tuning::TunedClaim& claim : result.claims)
    list.push(Json::object()
                  .set("that", claim.verdict.that)
                  .set("check", claim.verdict.check)
                  .set("value", claim.verdict.value)
                  .set("shown", claim.verdict.shown)
                  .set("start", claim.start)
                  .set("margin", claim.margin)
                  .set("holds", claim.verdict.holds)
                  .set("active", claim.active));
  return list;
}

Json tuned_starts_json(const tuning::TuneResult& result) {
  Json list = Json::list();
  for (const tuning::TunedStart& start : result.starts)
    list.push(Json::object()
                  .set("objective", start.objective ? Json(*start.objective) : Json())
                  .set("converged", start.converged)
                  .set("evaluations", start.evaluations));
  return list;
}

std::string unit_text(const std::optional<unit::Dimension>& dimension) {
  return dimension && *dimension != unit::Dimension{} ? unit::si_name(*dimension) : "";
}

}  // namespace

json::Json tune_json(const LoadedModel& model, const tuning::TuneResult& result) {
  Json numbers = Json::list();
  for (const tuning::TunedNumber& number : result.numbers) numbers.push(tuned_json(number));
  return Json::object()
      .set("file", model.file)
      .set("minimise", model.tune->objective_text())
      .set("parameters", std::move(numbers))
      .set("objective", result.objective)
      .set("unit", dimension_json(result.dimension))
      .set("start_objective", result.start_objective)
      .set("worst", result.worst.empty() ? Json() : Json(result.worst))
      .set("targets", tuned_targets_json(result))
      .set("singular_values", Json::list_of(result.resolution.singular_values))
      .set("claims", tuned_claims_json(result))
      .set("starts", tuned_starts_json(result))
      .set("findings", Json::list_of(result.findings))
      .set("method", result.method)
      .set("evaluations", result.history.size())
      .set("failed_evaluations", result.bad)
      .set("runs", result.runs)
      .set("feasible", result.feasible)
      .set("converged", result.converged)
      .set("interrupted", result.interrupted)
      .set("compiled", result.compiled)
      .set("duration", result.seconds);
}

std::string history_csv(const LoadedModel& model, const tuning::TuneResult& result) {
  enum State { holds, fails, failed };
  table::Table table{{{"evaluation", "", {}}, {"start", "", {}}, {"state", "", {}}}};
  for (const tuning::TunedNumber& number : result.numbers)
    table.columns.push_back({number.name, unit_text(number.dimension), {}});
  table.columns.push_back({"objective", unit_text(result.dimension), {}});
  const std::size_t claims = model.tune->constraints.size();
  for (std::size_t i = 0; i < claims; ++i) table.columns.push_back({fmt::format("margin.{}", i + 1), "", {}});
  for (std::size_t row = 0; row < result.history.size(); ++row) {
    const tuning::Evaluation& one = result.history[row];
    std::vector<double> cells{static_cast<double>(row + 1), static_cast<double>(one.start + 1),
                              static_cast<double>(one.is_bad()        ? failed
                                                  : one.is_feasible() ? holds
                                                                      : fails)};
    cells.insert(cells.end(), one.values.begin(), one.values.end());
    cells.push_back(one.objective);
    cells.insert(cells.end(), one.margins.begin(), one.margins.end());
    for (std::size_t i = 0; i < table.columns.size() && i < cells.size(); ++i)
      table.columns[i].values.push_back(cells[i]);
  }
  return table::csv_text(table, {{"state", {"holds", "fails", "no objective"}}});
}

std::string parameters_text(const LoadedModel& model, const tuning::TuneResult& result) {
  std::string text = fmt::format("# Tuned by {}; stepwire run FILE --set-from takes this file.\n",
                                 text::visible(model.file));
  for (const diagram::Setting& setting : result.settings)
    text += fmt::format("{}: {}\n", setting.name, setting.value);
  return text;
}

}  // namespace stepwire::session
