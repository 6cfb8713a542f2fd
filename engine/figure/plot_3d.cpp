#include <fmt/format.h>

#include <algorithm>

#include "engine/figure/plot_tools.hpp"

namespace stepwire {
namespace {

constexpr double space_budget = 4000.0, mesh_budget = 2500.0;

using Channels = std::vector<const Series*>;

/// Every so many rows of a curve, and its last one.
Curve every_row(const Curve& curve, std::size_t step) {
  Curve result{std::vector<std::vector<double>>(curve.columns.size()), curve.group};
  for (std::size_t i = 0; i < curve.columns.size(); ++i) {
    const std::vector<double>& from = curve.columns[i];
    for (std::size_t row = 0; row < from.size(); row += step) result.columns[i].push_back(from[row]);
    if ((from.size() - 1) % step != 0) result.columns[i].push_back(from.back());
  }
  return result;
}

/// The runs that the condition of a sheet selects, one line of a mesh each.
std::vector<Curve> lines_of(const Series& sheet, const Panel& panel, const Recording& recording,
                            Channels channels, std::size_t most) {
  channels.push_back(&sheet);
  std::vector<Curve> lines = gather(panel, recording, channels).curves;
  std::erase_if(lines, [](const Curve& line) { return std::ranges::count(line.columns.back(), 0.0) > 0; });
  std::size_t rows = 0;
  for (const Curve& line : lines) rows += line.size();
  for (Curve& line : lines) line = every_row(line, rows / std::max<std::size_t>(most, 1) + 1);
  return lines;
}

void draw_sheets(const Panel& panel, const Recording& recording, const Channels& channels, Script& script) {
  const auto found = panel.series.find("sheets");
  if (found == panel.series.end()) return;
  script.set("set pm3d depthorder corners2color mean");
  const auto most =
      static_cast<std::size_t>(mesh_budget * script.share / static_cast<double>(found->second.size()));
  for (const Series& sheet : found->second) {
    const std::vector<Curve> lines = lines_of(sheet, panel, recording, channels, most);
    if (lines.size() > 1)
      script.plot(script.net(lines) +
                  (channels.size() > 3 ? " using 1:2:3:4 with pm3d" : " using 1:2:3 with pm3d"));
  }
}

void draw_space(const Panel& panel, std::span<const Recording> recordings, Script& script) {
  const Series* color = panel.find("color");
  Channels channels{panel.find("x"), panel.find("y"), panel.find("z")};
  if (color != nullptr) channels.push_back(color);
  const Curves all = gather(panel, recording_of(panel, recordings), channels);
  const auto budget = static_cast<std::size_t>(space_budget * script.share);
  const auto style = panel.words.find("style");
  const bool points_only = style != panel.words.end() && style->second == "points";
  std::vector<Curve> curves;
  for (std::size_t group = 0; group < all.groups.size(); ++group)
    std::ranges::copy(points_only ? cut(all, group, budget / all.groups.size())
                                  : thinned(all, group, budget / all.groups.size(), color != nullptr),
                      std::back_inserter(curves));
  const Curve points = joined(all);
  const char* axes[] = {"x", "y", "z"};
  for (std::size_t i = 0; i < 3; ++i) {
    script.label(axes[i], *channels[i]);
    const Extent extent = points.columns.empty() ? Extent{} : extent_of(points.columns[i]);
    script.range(axes[i], extent.padded(0.03));
  }
  if (color != nullptr && !points.columns.empty()) script.color_bar(*color, extent_of(points.columns[3]));
  script.space = true;
  script.set(fmt::format("set view {},{},1,1\nset xyplane 0\nset border 4095 lc rgb '#bdbdbd' lw 0.6",
                         number_or(panel, "elevation", 62.0), number_or(panel, "azimuth", 35.0)));
  script.set("set xlabel rotate parallel\nset ylabel rotate parallel\nset zlabel rotate parallel");
  // Where x and y meet at the front, the last label of one would touch the first of the other.
  script.set(
      "set grid x y z vertical\nset tics scale 0.4\nset xtics offset -1.0,-0.4\nset ytics offset 1.4,-0.5");
  if (panel.equal) script.set("set view equal xyz");
  if (curves.empty()) return;
  if (panel.series.contains("sheets"))
    return draw_sheets(panel, recording_of(panel, recordings), channels, script);
  script.plot(fmt::format("{} using 1:2:3{} with {} {}", script.data(curves), color != nullptr ? ":4" : "",
                          points_only ? "points pt 7 ps 0.45" : "lines lw 2.2",
                          color != nullptr ? "lc palette" : "lc rgb '" + curve_color(0) + "'"));
}

}  // namespace

PlotKind space_plot() {
  return {
      "3d",
      "curves, points or surfaces in space, coloured by a fourth quantity if there is one",
      {{"x", "first axis", true},
       {"y", "second axis", true},
       {"z", "third axis, upwards", true},
       {"color", "shown as colour, with a colour bar"},
       {"sheets",
        "conditions, each of which selects runs of a sweep, such as elevation == 0 deg: in place of curves a "
        "coloured surface is spanned between those that follow each other",
        false, true}},
      {{"style", "lines (default) or points", "", false, {"lines", "points"}},
       {"elevation", "angle between the view and the upward axis in degrees (62)"},
       {"azimuth", "turn of the view about the upward axis in degrees (35)"}},
      false,
      draw_space};
}

}  // namespace stepwire
