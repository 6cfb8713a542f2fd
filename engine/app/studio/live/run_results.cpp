#include "engine/app/studio/live/run_results.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "engine/app/session/outcome.hpp"
#include "engine/app/studio/live/recorded_so_far.hpp"
#include "engine/base/table/table_file.hpp"
#include "engine/view/plot/figure_spec.hpp"

namespace stepwire::live {
namespace {

using json::Json;

constexpr std::int64_t most_exported = 2'000'000;  // numbers: 40 MB of text
constexpr std::size_t most_described = 256;        // columns

constexpr std::int64_t first_set = 1;  // tick 1: tick 0 is computed before any value can be set

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

/// Values set in a run, at its start and later.
struct SetValues {
  explicit SetValues(const EventLog& log) : start(log.last_of_each(first_set + 1)) {
    std::erase_if(start, &LiveEvent::is_input);
    const auto add = [&](const LiveEvent& event) {
      const bool known = std::ranges::any_of(
          on_way, [&](const LiveEvent& one) { return one.name == event.name && one.text == event.text; });
      if (!event.is_input() && event.tick > first_set && !known) on_way.push_back(event);
    };
    std::map<std::string, bool> seen;
    for (const LiveEvent& event : log.events())
      if (event.tick > first_set && !std::exchange(seen[event.name], true)) add(event);
    for (const LiveEvent& event : log.last_of_each()) add(event);
  }

  /// Returns the values at the start, with `other` in place of the one of its name.
  std::vector<LiveEvent> with(const LiveEvent& other) const {
    std::vector<LiveEvent> values = start;
    std::erase_if(values, [&](const LiveEvent& event) { return event.name == other.name; });
    values.push_back(other);
    return values;
  }

  std::vector<LiveEvent> start, on_way;  ///< last event of each name; first and last later event of each name
};

std::vector<claim::Verdict> judged(LoadedRun& run, const std::vector<LiveEvent>& values,
                                   std::vector<record::Recording> recordings) {
  session::Outcome outcome;
  outcome.result.recordings = std::move(recordings);
  session::judge_claims(*run.model_with(values), outcome);
  return std::move(outcome.verdicts);
}

/// Opens the verdicts that depend on a value set later: those that change if that value replaces the one at
/// the start.
void note_dependence(LoadedRun& run, const SetValues& values,
                     const std::vector<record::Recording>& recordings,
                     std::vector<claim::Verdict>& verdicts) {
  for (const LiveEvent& event : values.on_way) {
    const std::vector<claim::Verdict> others = judged(run, values.with(event), recordings);
    for (std::size_t i = 0; i < std::min(verdicts.size(), others.size()); ++i) {
      claim::Verdict& verdict = verdicts[i];
      const claim::Verdict& other = others[i];
      const bool same =
          verdict.holds == other.holds && verdict.shown == other.shown && verdict.check == other.check;
      if (same || !verdict.note.empty()) continue;
      verdict.note = fmt::format("'{}' was set at {:.6g} s, and this reads it; begin anew to judge it",
                                 event.name, run.plan().time_of(event.tick));
    }
  }
}

}  // namespace

Json figures_now(LoadedRun& run) {
  const bool ended = run.thread().status().state == RunStatus::State::ended;
  const auto model = run.model_with(run.thread().log().last_of_each());
  session::Outcome outcome;
  outcome.result.recordings = recorded_so_far(run.model(), run.signals(), run.thread(), ended);
  session::add_shown(*model, outcome);
  Json figures = Json::list();
  for (const plot::Figure& figure : model->figures) {
    try {
      if (run.model().study)
        throw std::runtime_error("it is drawn of the trials of the study: './stepwire study'");
      figures.push(plot::figure_json(plot::figure_spec(figure, outcome.recordings())));
    } catch (const std::exception& error) {
      figures.push(Json::object().set("title", figure.title).set("fault", error.what()));
    }
  }
  return Json::object().set("figures", std::move(figures));
}

std::string csv_of(LoadedRun& run, const std::vector<std::size_t>& columns, double from, double to) {
  const std::int64_t first = run.tick_at(from);
  const std::int64_t end = std::min(run.tick_at(to + run.plan().diagram.step), run.store().end_tick());
  const auto count = static_cast<std::size_t>(std::max<std::int64_t>(0, end - first));
  if (static_cast<double>(count) * static_cast<double>(columns.size() + 1) > most_exported)
    throw std::runtime_error(fmt::format(
        "{} rows of {} signals are more than a page takes; choose a shorter stretch, or 'stepwire run "
        "--out DIR' for all of it",
        count, columns.size()));
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
  if (columns.size() > most_described)
    throw std::runtime_error("statistics are of at most 256 columns at once");
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
  const SetValues values(run.thread().log());
  const auto recordings = recorded_so_far(run.model(), run.signals(), run.thread(), true);
  std::vector<claim::Verdict> verdicts = judged(run, values.start, recordings);
  note_dependence(run, values, recordings, verdicts);
  for (const claim::Verdict& verdict : verdicts)
    claims.push(claim_json(verdict.that, verdict_of(verdict), words_of(verdict)));
  return Json::object().set("claims", std::move(claims));
}

}  // namespace stepwire::live
