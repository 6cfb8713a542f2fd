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

}  // namespace stepwire::live
