#include "engine/app/studio/live/run_results.hpp"

#include <algorithm>

#include "engine/app/session/outcome.hpp"
#include "engine/app/studio/live/recorded_so_far.hpp"
#include "engine/base/table/table_file.hpp"
#include "engine/view/plot/figure_spec.hpp"
#include "engine/view/scene/scene_states.hpp"

namespace stepwire::live {

namespace {

using json::Json;

constexpr std::int64_t most_exported = 5'000'000;  // rows

std::string verdict_of(const claim::Verdict& verdict) {
  if (!verdict.note.empty()) return "open";
  if (verdict.holds) return verdict.surprises() ? "FAIL" : "ok";
  return verdict.disagrees.empty() ? "FAIL" : "known";
}

std::string words_of(const claim::Verdict& verdict) {
  if (!verdict.note.empty()) return verdict.check + ": " + verdict.note;
  return verdict.check + ": " + verdict.shown +
         (verdict.disagrees.empty() ? "" : " (" + verdict.disagrees + ")");
}

Json claim_json(const std::string& that, const std::string& verdict, const std::string& text) {
  return Json::object().set("that", that).set("verdict", verdict).set("text", text);
}

}  // namespace

Json figures_now(LoadedRun& run) {
  const bool ended = run.thread().status().state == RunStatus::State::ended;
  std::vector<record::Recording> recordings =
      recorded_so_far(run.model(), run.signals(), run.thread(), ended);
  if (run.model().scene) scene::add_scene_states(*run.model().scene, recordings);
  Json figures = Json::list();
  for (const plot::Figure& figure : run.model().figures) {
    try {
      if (run.model().study)
        throw std::runtime_error("it is drawn of the trials of the study: './stepwire study'");
      figures.push(plot::figure_json(plot::figure_spec(figure, recordings)));
    } catch (const std::exception& error) {
      figures.push(Json::object().set("title", figure.title).set("fault", error.what()));
    }
  }
  return Json::object().set("figures", std::move(figures));
}

Json claims_now(LoadedRun& run) {
  const RunStatus status = run.thread().status();
  Json claims = Json::list();
  const char* open = status.state != RunStatus::State::ended ? ""
                     : !status.fault.empty()                 ? ": the run ended early"
                     : run.model().study                     ? ": it is about the trials of the study"
                                                             : nullptr;
  if (open) {
    for (const claim::Claim& claim : run.model().claims)
      claims.push(claim_json(claim.that, "open", claim.check + open));
    return Json::object().set("claims", std::move(claims));
  }
  session::Outcome outcome;
  outcome.result.recordings = recorded_so_far(run.model(), run.signals(), run.thread(), true);
  session::judge_claims(run.model(), outcome);
  for (const claim::Verdict& verdict : outcome.verdicts)
    claims.push(claim_json(verdict.that, verdict_of(verdict), words_of(verdict)));
  return Json::object().set("claims", std::move(claims));
}

std::string csv_of(LoadedRun& run, const std::vector<std::size_t>& columns, double from, double to) {
  const std::int64_t first = run.tick_at(from);
  const std::int64_t end =
      std::min({run.tick_at(to + run.plan().diagram.step), run.store().end_tick(), first + most_exported});
  const auto count = static_cast<std::size_t>(std::max<std::int64_t>(0, end - first));
  table::Table table;
  table.columns.push_back({"time", "s", {}});
  for (std::size_t i = 0; i < count; ++i)
    table.columns.front().values.push_back(run.store().time_of(first + static_cast<std::int64_t>(i)));
  for (const std::size_t index : columns) {
    const LiveColumn column = run.column(index);
    std::vector<double> values(count);
    run.store().read(run.stored(index), first, values);
    for (double& value : values) value = value * column.scale + column.offset;
    table.columns.push_back({column.name, column.unit, std::move(values)});
  }
  return table::csv_text(table);
}

Json statistics_of(LoadedRun& run, const std::vector<std::size_t>& columns, double from, double to) {
  const std::int64_t first = run.tick_at(from), last = std::max(first, run.tick_at(to));
  const double step = run.plan().diagram.step;
  Json list = Json::list();
  for (const std::size_t column : columns) {
    const SampleStatistics seen = run.store().statistics(run.stored(column), first, last + 1);
    list.push(Json::object()
                  .set("column", column)
                  .set("min", seen.least)
                  .set("max", seen.most)
                  .set("mean", seen.mean)
                  .set("rms", seen.rms)
                  .set("slope", seen.slope / step)
                  .set("first", seen.first)
                  .set("last", seen.last));
  }
  return Json::object().set("statistics", std::move(list));
}

}  // namespace stepwire::live
