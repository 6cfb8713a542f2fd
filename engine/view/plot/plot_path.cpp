#include "engine/view/plot/plot_tools.hpp"

namespace stepwire::plot {
namespace {

constexpr double piece_budget = 4000.0;  ///< each coloured segment is an element of the picture

void draw_path(const Panel& panel, std::span<const record::Recording> recordings, PlotBuilder& plot) {
  const query::Series &x = *panel.find("x"), &y = *panel.find("y"), &color = *panel.find("color");
  const geometry::Curves all = gather(panel, recording_of(panel, recordings), {&x, &y, &color});
  const auto budget = static_cast<std::size_t>(piece_budget * plot.share);
  std::vector<geometry::Curve> curves;
  for (std::size_t group = 0; group < all.groups.size(); ++group)
    std::ranges::copy(geometry::thinned(all, group, budget / all.groups.size(), true),
                      std::back_inserter(curves));
  plot.cover(curves);
  plot.plane(0.05);
  plot.label("x", x);
  plot.label("y", y);
  geometry::Curves drawn;
  drawn.curves = curves;
  const geometry::Curve points = joined(drawn);
  plot.color_bar(color, points.columns.empty() ? geometry::Extent{} : geometry::extent_of(points.columns[2]));
  if (!curves.empty()) plot.add(LineMark{plane_rows(curves), {"", 3.0}});
}

}  // namespace

PlotKind path_plot() {
  PlotKind kind{"path",
                "a path in the plane whose colour is a third quantity",
                {{"x", "along the horizontal axis", true},
                 {"y", "along the vertical axis", true},
                 {"color", "shown as colour, with a colour bar", true}},
                {},
                true,
                draw_path};
  kind.lacks = {KeyNeeds::legend};
  return kind;
}

}  // namespace stepwire::plot
