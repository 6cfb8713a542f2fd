#include <cmath>

#include "engine/analyse/query/number.hpp"
#include "engine/view/plot/overlay.hpp"
#include "engine/view/plot/overlay_drawing.hpp"

namespace stepwire::plot {
namespace {

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
