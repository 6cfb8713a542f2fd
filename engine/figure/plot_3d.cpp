#include <fmt/format.h>

#include "engine/figure/plot_tools.hpp"

namespace stepwire {
namespace {

constexpr double space_budget = 4000.0;

void draw_space(const Panel& panel, std::span<const Recording> recordings, Script& script) {
  const Series* color = panel.find("color");
  std::vector<const Series*> channels{panel.find("x"), panel.find("y"), panel.find("z")};
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
  script.plot(fmt::format("{} using 1:2:3{} with {} {}", script.data(curves), color != nullptr ? ":4" : "",
                          points_only ? "points pt 7 ps 0.45" : "lines lw 2.2",
                          color != nullptr ? "lc palette" : "lc rgb '" + curve_color(0) + "'"));
}

}  // namespace

PlotKind space_plot() {
  return {"3d",
          "curves or points in space, coloured by a fourth quantity if there is one",
          {{"x", "first axis", true},
           {"y", "second axis", true},
           {"z", "third axis, upwards", true},
           {"color", "shown as colour, with a colour bar"}},
          {{"style", "lines (default) or points", "", false, {"lines", "points"}},
           {"elevation", "angle between the view and the upward axis in degrees (62)"},
           {"azimuth", "turn of the view about the upward axis in degrees (35)"}},
          false,
          draw_space};
}

}  // namespace stepwire
