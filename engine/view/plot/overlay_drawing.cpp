#include "engine/view/plot/overlay_drawing.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "engine/analyse/query/number.hpp"
#include "engine/analyse/query/run_rows.hpp"
#include "engine/view/geometry/grid.hpp"

namespace stepwire::plot {
namespace {

/// Returns the variables of a formula in the first row that the panel selects, 0 for those that are no
/// column. Returns std::nullopt if no row is selected.
std::optional<std::vector<double>> first_row(const query::Formula& formula, const Panel& panel,
                                             std::span<const record::Recording> recordings) {
  std::vector<double> values(formula.columns.size(), 0.0);
  if (std::ranges::all_of(formula.columns, [](const auto& name) { return name == "x" || name == "y"; }))
    return values;
  const record::Recording& recording = recordings[formula.recording.value_or(0)];
  const query::RunRows rows = query::rows_of_run(panel.where, recording);
  if (rows.none()) return std::nullopt;
  for (std::size_t i = 0; i < values.size(); ++i)
    if (const table::Column* column = recording.table.find(formula.columns[i]))
      values[i] = column->values[rows.first];
  return values;
}

/// Writes the value of the panel's note in its upper left corner.
void draw_note(const Panel& panel, std::span<const record::Recording> recordings, PlotBuilder& plot) {
  const query::Series* note = panel.find("note");
  if (!note) return;
  const auto values = first_row(note->formula, panel, recordings);
  if (!values) return;
  const double value = note->unit.from_si(note->formula.expression(*values));
  const bool has_unit = !note->unit_text.empty() && note->unit_text != "1";
  plot.spec.texts.push_back({.text = fmt::format("{} {}{}{}", note->label, query::short_number(value),
                                                 has_unit ? " " : "", has_unit ? note->unit_text : ""),
                             .x = 0.03,
                             .y = 0.95,
                             .in_frame = true,
                             .align = TextMark::Align::left});
}

/// Returns values of a boundary over the displayed plane; `values` are its variables in a row.
geometry::Grid boundary_grid(const query::Formula& boundary, std::vector<double> values, const Panel& panel,
                             const PlotBuilder& plot) {
  constexpr std::size_t cells = 240;
  const query::Series *across = panel.find("x"), *up = panel.find("y");
  geometry::Grid grid{plot.x.low, plot.y.low, plot.x.width() / (cells - 1),      plot.y.width() / (cells - 1),
                      cells,      cells,      std::vector<double>(cells * cells)};
  for (std::size_t row = 0; row < cells; ++row)
    for (std::size_t column = 0; column < cells; ++column) {
      const double x = grid.x + static_cast<double>(column) * grid.dx;
      const double y = grid.y + static_cast<double>(row) * grid.dy;
      for (std::size_t i = 0; i < values.size(); ++i) {
        if (boundary.columns[i] == "x") values[i] = across ? across->unit.to_si(x) : x;
        if (boundary.columns[i] == "y") values[i] = up ? up->unit.to_si(y) : y;
      }
      grid.at(column, row) = boundary.expression(values);
    }
  return grid;
}

/// Draws curves where the boundaries of the panel are zero.
void draw_boundaries(const Panel& panel, std::span<const record::Recording> recordings, PlotBuilder& plot) {
  if (plot.x.empty() || plot.y.empty()) return;
  for (const query::Formula& boundary : panel.boundaries) {
    auto values = first_row(boundary, panel, recordings);
    if (!values) continue;
    const auto curves = contour(boundary_grid(boundary, std::move(*values), panel, plot), 0.0);
    if (!curves.empty()) plot.add(LineMark{plane_rows(curves), {"#111111", 1.6}});
  }
}

}  // namespace

void cover_overlays(const Panel& panel, std::span<const record::Recording> recordings, PlotBuilder& plot) {
  cover_regions(panel, plot);
  cover_marks(panel, plot);
  cover_motions(panel, recordings, plot);
  cover_roses(panel, plot);
}

void draw_overlays(const Panel& panel, std::span<const record::Recording> recordings, PlotBuilder& plot) {
  draw_boundaries(panel, recordings, plot);
  draw_note(panel, recordings, plot);
  draw_motions(panel, recordings, plot);
  draw_regions(panel, plot);
  draw_roses(panel, recordings, plot);
  draw_marks(panel, plot.width - room_across, plot.suitable_height() - room_up, plot);
  draw_texts(panel, plot);
}

}  // namespace stepwire::plot
