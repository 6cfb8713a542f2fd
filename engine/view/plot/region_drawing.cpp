#include <algorithm>
#include <iterator>

#include "engine/view/geometry/thinning.hpp"
#include "engine/view/plot/overlay_drawing.hpp"

namespace stepwire::plot {
namespace {

double drawn(const Panel& panel, const char* axis, double value) {
  const query::Series* series = panel.find(axis);
  return series ? series->unit.from_si(value) : value;
}

/// Returns a line in the units of the axes.
geometry::Curve curve_of(const Panel& panel, const Outline& outline, const Outline::Line& line) {
  geometry::Curve curve{std::vector<std::vector<double>>(outline.space ? 3 : 2), 0};
  const char* axes[] = {"x", "y", "z"};
  for (const Outline::Point& point : line.points)
    for (std::size_t i = 0; i < curve.columns.size(); ++i)
      curve.columns[i].push_back(drawn(panel, axes[i], point[i]));
  return curve;
}

/// True if a point is within the given ranges of its axes.
bool is_shown(const Panel& panel, const geometry::Curve& curve, std::size_t row) {
  const AxisOptions* axes[] = {&panel.x, &panel.y, &panel.z};
  for (std::size_t i = 0; i < curve.columns.size(); ++i) {
    if (!axes[i]->range) continue;
    const auto [low, high] = *axes[i]->range;
    const double hair = 1e-6 * (high - low), value = curve.columns[i][row];
    if (value < low - hair || value > high + hair) return false;
  }
  return true;
}

/// Returns the visible pieces of a line in space; renderers need not clip lines there.
std::vector<geometry::Curve> shown_pieces(const Panel& panel, const geometry::Curve& curve) {
  std::vector<geometry::Curve> pieces;
  bool inside = false;
  for (std::size_t row = 0; row < curve.size(); ++row) {
    const bool shown = is_shown(panel, curve, row);
    if (shown && !inside) pieces.push_back({std::vector<std::vector<double>>(curve.columns.size()), 0});
    for (std::size_t i = 0; shown && i < curve.columns.size(); ++i)
      pieces.back().columns[i].push_back(curve.columns[i][row]);
    inside = shown;
  }
  return pieces;
}

/// Returns the lines of an outline; in the plane without points that are indistinguishable in the frame.
std::vector<geometry::Curve> curves_of(const Panel& panel, const Outline& outline, const PlotBuilder& plot) {
  const std::vector<double> widths{plot.x.width(), plot.y.width()};
  std::vector<geometry::Curve> curves;
  for (const Outline::Line& line : outline.lines) {
    const geometry::Curve curve = curve_of(panel, outline, line);
    if (outline.space)
      std::ranges::move(shown_pieces(panel, curve), std::back_inserter(curves));
    else
      curves.push_back(geometry::simplify(curve, widths, geometry::unseen, false));
  }
  return curves;
}

/// Returns all loops as one polygon, which returns from each loop to the beginning of the first. Holes have
/// the opposite orientation and stay empty.
geometry::Curve one_of(const std::vector<geometry::Curve>& loops) {
  geometry::Curve all{std::vector<std::vector<double>>(2), 0};
  for (const geometry::Curve& loop : loops)
    for (std::size_t i = 0; i < 2; ++i) {
      std::vector<double>& to = all.columns[i];
      to.insert(to.end(), loop.columns[i].begin(), loop.columns[i].end());
      to.push_back(loop.columns[i].front());
      to.push_back(all.columns[i].front());
    }
  return all;
}

/// Clips a polygon at a line of the frame, since renderers need not clip areas.
geometry::Curve cut_off(const geometry::Curve& polygon, std::size_t axis, double limit, double side) {
  geometry::Curve result{std::vector<std::vector<double>>(2), 0};
  const auto inside = [&](std::size_t i) { return side * (polygon.columns[axis][i] - limit) <= 0.0; };
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const std::size_t before = i == 0 ? polygon.size() - 1 : i - 1;
    const double from = polygon.columns[axis][before], to = polygon.columns[axis][i];
    for (std::size_t k = 0; k < 2 && inside(i) != inside(before); ++k) {
      const double a = polygon.columns[k][before], b = polygon.columns[k][i];
      result.columns[k].push_back(k == axis ? limit : a + (b - a) * (limit - from) / (to - from));
    }
    for (std::size_t k = 0; k < 2 && inside(i); ++k) result.columns[k].push_back(polygon.columns[k][i]);
  }
  return result;
}

geometry::Curve within(geometry::Curve polygon, const PlotBuilder& plot) {
  const geometry::Extent extents[] = {plot.x, plot.y};
  for (std::size_t axis = 0; axis < 2; ++axis) {
    polygon = cut_off(polygon, axis, extents[axis].low, -1.0);
    polygon = cut_off(polygon, axis, extents[axis].high, 1.0);
  }
  return polygon;
}

}  // namespace

void cover_regions(const Panel& panel, PlotBuilder& plot) {
  for (const auto& [name, outline] : panel.regions)
    for (const Outline::Line& line : outline.lines)
      if (!outline.space && !line.endless) plot.cover({curve_of(panel, outline, line)});
}

void draw_regions(const Panel& panel, PlotBuilder& plot) {
  const std::vector<double> dash =
      panel.dashed_regions ? std::vector<double>{2.5, 4.0} : std::vector<double>{};
  for (const auto& [name, outline] : panel.regions) {
    const std::vector<geometry::Curve> curves = curves_of(panel, outline, plot);
    if (!curves.empty())
      plot.add(LineMark{outline.space ? space_rows(curves) : plane_rows(curves), {"#111111", 1.6, dash}});
    if (outline.space) continue;
    const geometry::Curve shade = within(one_of(curves), plot);
    if (shade.size() > 2) plot.add_below(AreaMark{shade.columns[0], shade.columns[1], "#e6eee2"});
  }
}

}  // namespace stepwire::plot
