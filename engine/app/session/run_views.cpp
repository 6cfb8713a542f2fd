#include "engine/app/session/run_views.hpp"

#include <fmt/format.h>

namespace stepwire::session {

RunViews::RunViews(const LoadedModel& model, const record::Recording& recording, std::size_t first,
                   std::size_t number)
    : recording_(recording), first_(first), words_(recording.categories) {
  const auto& sweep = model.job.plan.diagram.sweep;
  if (model.kept && number > 0) points_ = sweep->recorded_points();
  // If a sweep keeps one row per run, its rows form a single table.
  if (sweep && !model.job.points.empty() && (sweep->keep == diagram::Sweep::Keep::rows || !points_.empty()))
    for (const diagram::Sweep::Axis& axis : sweep->axes) swept_.insert(axis.parameter);
  for (record::Categories& column : words_)
    for (std::string& text : column.texts) text = without_quotes(text);
}

std::span<const std::string> RunViews::words_of(const std::string& column) const {
  for (const record::Categories& words : words_)
    if (words.column == column) return words.texts;
  return {};
}

table::RunView RunViews::view(std::size_t run) const {
  const bool only = count() == 1 && swept_.empty();
  const std::size_t first = only ? 0 : recording_.starts[run];
  const bool last = only || run + 1 == recording_.starts.size();
  const std::size_t end = last ? recording_.table.rows() : recording_.starts[run + 1];
  table::RunView view;
  if (!only) view.name = fmt::format("run-{}", (points_.empty() ? first_ + run : points_[run]) + 1);
  for (const table::Column& column : recording_.table.columns) {
    const auto words = words_of(column.name);
    if (!swept_.contains(column.name)) {
      view.series.push_back(
          {column.name, column.unit, std::span(column.values).subspan(first, end - first), words});
    } else if (first < end) {
      const double number = column.values[first];
      const bool word = number >= 0.0 && number < static_cast<double>(words.size());
      view.swept.push_back(
          {column.name, column.unit, number, word ? words[static_cast<std::size_t>(number)] : ""});
    }
  }
  return view;
}

}  // namespace stepwire::session
