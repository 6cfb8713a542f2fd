#include "engine/figure/region_drawing.hpp"

#include <algorithm>
#include <iterator>

#include "engine/figure/thinning.hpp"

namespace stepwire {
namespace {

double drawn(const Panel& panel, const char* axis, double value) {
  const Series* series = panel.find(axis);
  return series ? series->unit.from_si(value) : value;
}

/// A line in the units of the axes.
Curve curve_of(const Panel& panel, const Outline& outline, const Outline::Line& line) {
  Curve curve{std::vector<std::vector<double>>(outline.space ? 3 : 2), 0};
  const char* axes[] = {"x", "y", "z"};
  for (const Outline::Point& point : line.points)
    for (std::size_t i = 0; i < curve.columns.size(); ++i)
      curve.columns[i].push_back(drawn(panel, axes[i], point[i]));
  return curve;
}

/// Does a point lie within the ranges that the file gives for its axes?
bool is_shown(const Panel& panel, const Curve& curve, std::size_t row) {
  const char* axes[] = {"x_range", "y_range", "z_range"};
  for (std::size_t i = 0; i < curve.columns.size(); ++i) {
    const auto range = panel.ranges.find(axes[i]);
    if (range == panel.ranges.end()) continue;
    const double hair = 1e-6 * (range->second[1] - range->second[0]), value = curve.columns[i][row];
    if (value < range->second[0] - hair || value > range->second[1] + hair) return false;
  }
  return true;
}

/// The pieces of a line in space that are shown; gnuplot does not cut lines there.
std::vector<Curve> shown_pieces(const Panel& panel, const Curve& curve) {
  std::vector<Curve> pieces;
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

/// The lines of an outline; in the plane without points that cannot be told apart in the frame.
std::vector<Curve> curves_of(const Panel& panel, const Outline& outline, const Script& script) {
  const std::vector<double> widths{script.x.high - script.x.low, script.y.high - script.y.low};
  std::vector<Curve> curves;
  for (const Outline::Line& line : outline.lines) {
    const Curve curve = curve_of(panel, outline, line);
    if (outline.space)
      std::ranges::move(shown_pieces(panel, curve), std::back_inserter(curves));
    else
      curves.push_back(simplify(curve, widths, unseen, false));
  }
  return curves;
}

/// All loops as one, from each back to where the first begins: holes run the other way around, and stay free.
Curve one_of(const std::vector<Curve>& loops) {
  Curve all{std::vector<std::vector<double>>(2), 0};
  for (const Curve& loop : loops)
    for (std::size_t i = 0; i < 2; ++i) {
      std::vector<double>& to = all.columns[i];
      to.insert(to.end(), loop.columns[i].begin(), loop.columns[i].end());
      to.push_back(loop.columns[i].front());
      to.push_back(all.columns[i].front());
    }
  return all;
}

/// What of a polygon lies on one side of a line of the frame. gnuplot does not keep large areas within it.
Curve cut_off(const Curve& polygon, std::size_t axis, double limit, double side) {
  Curve result{std::vector<std::vector<double>>(2), 0};
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

Curve within(Curve polygon, const Script& script) {
  const Extent extents[] = {script.x, script.y};
  for (std::size_t axis = 0; axis < 2; ++axis) {
    polygon = cut_off(polygon, axis, extents[axis].low, -1.0);
    polygon = cut_off(polygon, axis, extents[axis].high, 1.0);
  }
  return polygon;
}

}  // namespace

void cover_regions(const Panel& panel, Script& script) {
  for (const Outline& outline : panel.regions)
    for (const Outline::Line& line : outline.lines)
      if (!outline.space && !line.endless) script.cover({curve_of(panel, outline, line)});
}

void draw_regions(const Panel& panel, Script& script) {
  if (!panel.regions.empty()) script.set("set clip two");  // a line may begin and end beyond the frame
  const auto line = panel.words.find("region_line");
  const std::string dashes = line != panel.words.end() && line->second == "dashes" ? " dt 2" : "";
  for (const Outline& outline : panel.regions) {
    const std::vector<Curve> curves = curves_of(panel, outline, script);
    const std::string columns = outline.space ? "1:2:3" : "1:2";
    if (!curves.empty())
      script.plot(script.data(curves) + " using " + columns + " with lines lc rgb '#111111' lw 1.6" + dashes);
    if (outline.space) continue;
    const Curve shade = within(one_of(curves), script);
    if (shade.size() > 2)
      script.plot_below(script.data({shade}) +
                        " using 1:2 with filledcurves closed fc rgb '#e6eee2' fs solid noborder");
  }
}

}  // namespace stepwire
