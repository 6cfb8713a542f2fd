#include "engine/app/studio/live/recorded_so_far.hpp"

#include <algorithm>

#include "engine/simulate/run/number_row.hpp"
#include "engine/simulate/run/pooling.hpp"

namespace stepwire::live {

namespace {

/// Returns the ticks of the rows of an entry.
std::vector<std::int64_t> ticks_of(const plan::Plan& plan, const diagram::RecordRequest& request,
                                   std::int64_t from, std::int64_t end, bool ended) {
  const std::int64_t every = record::ticks_between_rows(plan, request);
  std::vector<std::int64_t> ticks;
  for (std::int64_t tick = (from + every - 1) / every * every; tick < end; tick += every)
    ticks.push_back(tick);
  if (ended && end > 0 && (end - 1) % every != 0) ticks.push_back(end - 1);
  return ticks;
}

/// Returns the values of a stored column at these ticks.
std::vector<double> picked(const SampleStore& store, std::size_t column,
                           const std::vector<std::int64_t>& ticks) {
  std::vector<double> values, part;
  values.reserve(ticks.size());
  for (std::size_t i = 0; i < ticks.size();) {
    const std::int64_t first = ticks[i];
    part.resize(
        static_cast<std::size_t>(std::min<std::int64_t>(SampleColumn::chunk, ticks.back() - first + 1)));
    store.read(column, first, part);
    for (; i < ticks.size() && ticks[i] - first < std::ssize(part); ++i)
      values.push_back(part[static_cast<std::size_t>(ticks[i] - first)]);
  }
  return values;
}

/// Adds the columns of swept parameters, each with its present value.
void add_swept(const diagram::Diagram& diagram, RunControl& run, record::Recording& recording) {
  if (!diagram.sweep) return;
  auto place = recording.table.columns.begin() + 1;
  for (const diagram::Sweep::Axis& axis : diagram.sweep->axes) {
    const auto parameter =
        std::ranges::find(diagram.parameters, axis.parameter, &diagram::DiagramParameter::name);
    const bool known = parameter != diagram.parameters.end();
    double value = run.value(axis.parameter).value_or(0.0);
    if (run::has_words(axis)) {
      const std::vector<std::string> words = run::words_of(axis);
      const auto word = std::ranges::find(words, known ? parameter->text : "");
      value = word == words.end() ? 0.0 : static_cast<double>(word - words.begin());
      recording.categories.push_back({axis.parameter, words});
    }
    const std::string unit =
        known && parameter->dimension ? unit::si_name(*parameter->dimension) : std::string();
    const std::size_t rows = recording.table.rows();
    place =
        recording.table.columns.insert(place, {axis.parameter, unit, std::vector<double>(rows, value)}) + 1;
  }
}

void leave_last_row(record::Recording& recording) {
  for (table::Column& column : recording.table.columns)
    if (column.values.size() > 1) column.values = {column.values.back()};
}

}  // namespace

std::vector<record::Recording> recorded_rows(const plan::Plan& plan, const SignalList& signals,
                                             RunControl& run, bool ended, std::int64_t from) {
  const std::int64_t end = run.store().end_tick();
  std::vector<record::Recording> recordings;
  for (const diagram::RecordRequest& request : plan.diagram.records) {
    record::Recording& recording = recordings.emplace_back();
    recording.table.columns = record::empty_columns(plan, request);
    const std::vector<std::int64_t> ticks = ticks_of(plan, request, from, end, ended);
    for (const std::int64_t tick : ticks)
      recording.table.columns.front().values.push_back(plan.time_of(tick));
    for (std::size_t i = 1; i < recording.table.columns.size(); ++i) {
      table::Column& column = recording.table.columns[i];
      column.values = picked(run.store(), run.stored(*signals.find(column.name)), ticks);
    }
  }
  return recordings;
}

std::vector<record::Recording> recorded_so_far(const session::LoadedModel& model, const SignalList& signals,
                                               RunControl& run, bool ended, std::int64_t from) {
  auto recordings = recorded_rows(model.job.plan, signals, run, ended, from);
  for (record::Recording& recording : recordings) add_swept(model.job.plan.diagram, run, recording);
  const auto& sweep = model.job.plan.diagram.sweep;
  if (sweep && sweep->keep == diagram::Sweep::Keep::final)
    for (record::Recording& recording : recordings) leave_last_row(recording);
  if (!model.kept) return recordings;
  record::Recording row = run::number_row(*model.kept, recordings);
  add_swept(model.job.plan.diagram, run, row);
  if (sweep->recorded_runs == 0) return {row};
  recordings.insert(recordings.begin(), std::move(row));
  return recordings;
}

}  // namespace stepwire::live
