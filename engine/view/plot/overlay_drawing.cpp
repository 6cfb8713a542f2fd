#include "engine/view/plot/overlay_drawing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/analyse/query/number.hpp"
#include "engine/analyse/query/run_rows.hpp"
#include "engine/view/geometry/grid.hpp"
#include "engine/view/geometry/thinning.hpp"
#include "engine/view/plot/overlay.hpp"

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

std::vector<geometry::Curve> curves_of(const Motion& motion, std::span<const record::Recording> recordings) {
  return overlay_rows(motion.where, recordings[motion.recording], {&motion.x, &motion.y});
}

double length_to(const geometry::Curve& curve, std::size_t row) {
  return std::hypot(curve.columns[0][row] - curve.columns[0][row - 1],
                    curve.columns[1][row] - curve.columns[1][row - 1]);
}

double length_of(const geometry::Curve& curve) {
  double length = 0.0;
  for (std::size_t row = 1; row < curve.size(); ++row) length += length_to(curve, row);
  return length;
}

/// Adds arrow heads at equal distances, each at the end of a small step to its place.
void add_heads(const geometry::Curve& curve, double count, VectorsMark& heads) {
  const double distance = length_of(curve) / count, tail = 1e-3 * distance;
  double gone = 0.0, next = 0.5 * distance;
  for (std::size_t row = 1; row < curve.size(); ++row) {
    const double step = length_to(curve, row);
    const auto way = [&](std::size_t i) {
      return (curve.columns[i][row] - curve.columns[i][row - 1]) / step;
    };
    for (; step > 0.0 && next <= gone + step; next += distance) {
      heads.x.push_back(curve.columns[0][row - 1] + (next - gone) * way(0));
      heads.y.push_back(curve.columns[1][row - 1] + (next - gone) * way(1));
      heads.dx.push_back(tail * way(0));
      heads.dy.push_back(tail * way(1));
    }
    gone += step;
  }
}

enum RoseColumn { point_x, point_y, spoke_angle, spoke_value };

/// Rose with its rows and the centre of its disc.
struct DrawnRose {
  const Rose& rose;
  geometry::Curve rows;
  double x, y;

  MarkRows circle() const {
    constexpr int corners = 72;
    constexpr double turn = 6.283185307179586;
    MarkRows line;
    for (int i = 0; i <= corners; ++i) {
      line.x.push_back(x + rose.radius * std::cos(turn * i / corners));
      line.y.push_back(y + rose.radius * std::sin(turn * i / corners));
    }
    return line;
  }

  /// Returns the spokes from the centre of the disc; the largest value has the length of the radius.
  VectorsMark spokes(double full) const {
    VectorsMark spokes;
    for (std::size_t row = 0; row < rows.size(); ++row) {
      const double angle = rows.columns[spoke_angle][row], value = rows.columns[spoke_value][row];
      const double length = full > 0.0 ? rose.radius * value / full : 0.0;
      spokes.x.push_back(x);
      spokes.y.push_back(y);
      spokes.dx.push_back(length * std::cos(angle));
      spokes.dy.push_back(length * std::sin(angle));
      spokes.value.push_back(value);
    }
    return spokes;
  }

  /// Returns the line from the point to the edge of the disc; std::nullopt if the point is on the disc.
  std::optional<MarkRows> leader() const {
    const double from_x = rows.columns[point_x].front(), from_y = rows.columns[point_y].front();
    const double distance = std::hypot(from_x - x, from_y - y);
    if (distance <= rose.radius) return std::nullopt;
    const double share = rose.radius / distance;
    return MarkRows{{from_x, x + share * (from_x - x)}, {from_y, y + share * (from_y - y)}, {}, {}};
  }
};

std::vector<DrawnRose> drawn_roses(const Panel& panel, std::span<const record::Recording> recordings) {
  std::vector<DrawnRose> drawn;
  for (const Rose& rose : panel.roses)
    for (geometry::Curve& rows :
         overlay_rows(rose.where, recordings[rose.recording], {&rose.x, &rose.y, &rose.angle, &rose.value})) {
      const double x = rose.at ? (*rose.at)[0] : rows.columns[point_x].front();
      const double y = rose.at ? (*rose.at)[1] : rows.columns[point_y].front();
      drawn.push_back({rose, std::move(rows), x, y});
    }
  return drawn;
}

double largest_value(const std::vector<DrawnRose>& roses) {
  double largest = 0.0;
  for (const DrawnRose& one : roses)
    for (const double value : one.rows.columns[spoke_value]) largest = std::max(largest, value);
  return largest;
}

TextMark name_of(const DrawnRose& one, const std::string& text, double side) {
  return {.text = text,
          .x = one.x,
          .y = one.y + side * one.rose.radius,
          .offset = {0.0, 0.8 * side},
          .size = 12.0,
          .color = "#101010",
          .rim = true};
}

void write_names(const DrawnRose& one, double full, PlotBuilder& plot) {
  const std::string unit = query::printed_unit(one.rose.value.unit_text);
  plot.spec.texts.push_back(name_of(one, "edge: " + query::short_number(full, 3) + " " + unit, -1.0));
  if (!one.rose.name.empty()) plot.spec.texts.push_back(name_of(one, one.rose.name, 1.0));
}

void draw_leader(const MarkRows& leader, PlotBuilder& plot) {
  plot.add(LineMark{{leader}, {"#555555", 1.0}});
  plot.spec.texts.push_back({.x = leader.x[0], .y = leader.y[0], .dot = 3.9});
}

/// Returns the line through the ends of spokes.
LineMark outline_of(const VectorsMark& spokes) {
  MarkRows ends;
  for (std::size_t i = 0; i < spokes.x.size(); ++i) {
    ends.x.push_back(spokes.x[i] + spokes.dx[i]);
    ends.y.push_back(spokes.y[i] + spokes.dy[i]);
  }
  return {{std::move(ends)}, {"#222222", 1.4}};
}

void draw_rose(const DrawnRose& one, double full, PlotBuilder& plot) {
  const MarkRows disc = one.circle();
  plot.add(AreaMark{disc.x, disc.y, "#ffffff"});
  plot.add(LineMark{{disc}, {"#555555", 1.0}});
  if (const auto leader = one.leader()) draw_leader(*leader, plot);
  VectorsMark spokes = one.spokes(full);
  spokes.line = {plot.spec.color ? "" : curve_color(0), 1.6};
  LineMark outline = outline_of(spokes);
  plot.add(std::move(spokes));
  plot.add(std::move(outline));
  write_names(one, full, plot);
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

void cover_motions(const Panel& panel, std::span<const record::Recording> recordings, PlotBuilder& plot) {
  for (const Motion& motion : panel.motions) plot.cover(curves_of(motion, recordings));
}

void draw_motions(const Panel& panel, std::span<const record::Recording> recordings, PlotBuilder& plot) {
  for (const Motion& motion : panel.motions) {
    std::vector<geometry::Curve> lines;
    VectorsMark heads{
        .line = {motion.color, 2.0}, .pivot = 1.0, .head = 0.013, .head_angle = 22.0, .fixed_heads = true};
    for (const geometry::Curve& curve : curves_of(motion, recordings)) {
      if (motion.heads > 0.0) add_heads(curve, motion.heads, heads);
      lines.push_back(geometry::simplify(curve, {plot.x.width(), plot.y.width()}, geometry::unseen, false));
    }
    if (lines.empty()) continue;
    // a later call of add_below() draws deeper
    if (!heads.x.empty()) plot.add_below(std::move(heads));
    plot.add_below(LineMark{plane_rows(lines), {motion.color, 2.0}});
  }
}

void cover_roses(const Panel& panel, PlotBuilder& plot) {
  for (const Rose& rose : panel.roses) {
    if (!rose.at) continue;
    for (const double side : {-rose.radius, rose.radius}) {
      plot.x.add((*rose.at)[0] + side);
      plot.y.add((*rose.at)[1] + side);
    }
  }
}

void draw_roses(const Panel& panel, std::span<const record::Recording> recordings, PlotBuilder& plot) {
  const std::vector<DrawnRose> roses = drawn_roses(panel, recordings);
  const double full = largest_value(roses);
  for (const DrawnRose& one : roses) draw_rose(one, full, plot);
}

}  // namespace stepwire::plot
