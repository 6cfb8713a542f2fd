#include "engine/view/plot/last_rows.hpp"

#include <algorithm>
#include <cmath>

#include "engine/view/plot/plot_kind.hpp"

namespace stepwire::plot {
namespace {

/// True if a formula reads columns other than the coordinates x and y.
bool reads_columns(const query::Formula& formula) {
  return std::ranges::any_of(formula.columns, [](const auto& name) { return name != "x" && name != "y"; });
}

/// True if the panel has overlays, which have rows of their own.
bool has_overlays(const Panel& panel) {
  const query::Series* note = panel.find("note");
  return !panel.motions.empty() || !panel.roses.empty() || (note && reads_columns(note->formula)) ||
         std::ranges::any_of(panel.boundaries, reads_columns);
}

/// Returns the drawn values of a recording; NaN for values that have no place on an axis.
std::vector<std::vector<double>> shown_values(const Panel& panel, const record::Recording& run,
                                              std::size_t recording) {
  std::vector<std::vector<double>> shown;
  for (const auto& [key, list] : panel.series)
    for (const query::Series& series : list) {
      if (series.formula.recording.value_or(recording) != recording) continue;
      shown.push_back(query::evaluate(series.formula, run));
      for (double& value : shown.back())
        if (panel.axis(key).log && !(series.unit.from_si(value) > 0.0)) value = query::nothing;
    }
  return shown;
}

bool holds(double value) {
  return value != 0.0 && !std::isnan(value);
}

}  // namespace

RowsRead rows_read(const Panel& panel, std::size_t recordings) {
  if (panel.content) return panel.reads_rows ? RowsRead::all : RowsRead::none;
  const auto is_of_runs = [&](std::size_t recording) { return recording < recordings; };
  if (has_overlays(panel)) return RowsRead::all;
  if (std::ranges::none_of(panel.recordings, is_of_runs)) return RowsRead::none;
  if (panel.reads_all_rows || !panel.numbers.empty()) return RowsRead::all;
  return panel.final_rows || panel.kind->last_rows ? RowsRead::last : RowsRead::all;
}

std::size_t first_drawn_row(const Panel& panel, std::span<const record::Recording> run,
                            std::size_t recording) {
  const auto shown = shown_values(panel, run[recording], recording);
  const std::size_t rows = run[recording].table.rows();
  const auto where =
      panel.where ? query::evaluate(*panel.where, run[recording]) : std::vector<double>(rows, 1.0);
  std::size_t first = rows;
  for (std::size_t row = rows; row-- > 0;) {
    if (!holds(where[row])) continue;
    first = row;
    const auto is_shown = [&](const auto& values) { return std::isfinite(values[row]); };
    if (std::ranges::all_of(shown, is_shown)) return row;
  }
  return first;
}

}  // namespace stepwire::plot
