#include <algorithm>

#include "engine/view/plot/plot_tools.hpp"

namespace stepwire::plot {
namespace {

struct SpaceOptions {
  double elevation = 62.0, azimuth = 35.0;  ///< of the view [deg]
};

constexpr double space_budget = 4000.0, mesh_budget = 2500.0;

using Channels = std::vector<const query::Series*>;

/// Returns every `step`-th row of a curve, and its last one.
geometry::Curve every_row(const geometry::Curve& curve, std::size_t step) {
  geometry::Curve result{std::vector<std::vector<double>>(curve.columns.size()), curve.group};
  for (std::size_t i = 0; i < curve.columns.size(); ++i) {
    const std::vector<double>& from = curve.columns[i];
    for (std::size_t row = 0; row < from.size(); row += step) result.columns[i].push_back(from[row]);
    if ((from.size() - 1) % step != 0) result.columns[i].push_back(from.back());
  }
  return result;
}

/// Returns the runs that the condition of a sheet selects, as lines of a mesh.
std::vector<geometry::Curve> lines_of(const query::Series& sheet, const Panel& panel,
                                      const record::Recording& recording, Channels channels,
                                      std::size_t most) {
  channels.push_back(&sheet);
  std::vector<geometry::Curve> lines = gather(panel, recording, channels).curves;
  std::erase_if(lines,
                [](const geometry::Curve& line) { return std::ranges::count(line.columns.back(), 0.0) > 0; });
  std::size_t rows = 0;
  for (const geometry::Curve& line : lines) rows += line.size();
  for (geometry::Curve& line : lines) line = every_row(line, rows / std::max<std::size_t>(most, 1) + 1);
  return lines;
}

void draw_sheets(const Panel& panel, const record::Recording& recording, const Channels& channels,
                 PlotBuilder& plot) {
  const std::vector<query::Series>& sheets = panel.series.at("sheets");
  const auto most = static_cast<std::size_t>(mesh_budget * plot.share / static_cast<double>(sheets.size()));
  for (const query::Series& sheet : sheets) {
    std::vector<geometry::Curve> lines = lines_of(sheet, panel, recording, channels, most);
    for (geometry::Curve& line : lines) line.columns.resize(channels.size());  // without the condition
    if (lines.size() > 1) plot.add(SurfaceMark{space_rows(lines)});
  }
}

void draw_points(const std::vector<geometry::Curve>& curves, bool colored, PlotBuilder& plot) {
  geometry::Curves all;
  all.curves = curves;
  plot.add(PointsMark{
      .rows = space_rows({joined(all)}).front(), .size = 4.3875, .color = colored ? "" : curve_color(0)});
}

/// Returns the curves of all groups, reduced to the budget of the picture.
std::vector<geometry::Curve> drawn_in_space(const geometry::Curves& all, const Panel& panel, bool colored,
                                            double share) {
  const std::size_t groups = std::max<std::size_t>(all.groups.size(), 1);
  const std::size_t budget = static_cast<std::size_t>(space_budget * share) / groups;
  std::vector<geometry::Curve> curves;
  for (std::size_t group = 0; group < all.groups.size(); ++group)
    std::ranges::copy(panel.points_only ? geometry::cut(all, group, budget)
                                        : geometry::thinned(all, group, budget, colored),
                      std::back_inserter(curves));
  return curves;
}

void set_axes(const geometry::Curve& points, const Channels& channels, PlotBuilder& plot) {
  const char* axes[] = {"x", "y", "z", "color"};
  for (std::size_t i = 0; i < 3; ++i) {
    plot.label(axes[i], *channels[i]);
    const geometry::Extent extent =
        points.columns.empty() ? geometry::Extent{} : geometry::extent_of(points.columns[i]);
    plot.range(axes[i], extent.padded(0.03));
  }
  if (channels.size() > 3 && !points.columns.empty())
    plot.color_bar(*channels[3], geometry::extent_of(points.columns[3]));
}

void draw_space(const Panel& panel, std::span<const record::Recording> recordings, PlotBuilder& plot) {
  const query::Series* color = panel.find("color");
  Channels channels{panel.find("x"), panel.find("y"), panel.find("z")};
  if (color) channels.push_back(color);
  const geometry::Curves all = gather(panel, recording_of(panel, recordings), channels);
  const std::vector<geometry::Curve> curves = drawn_in_space(all, panel, color != nullptr, plot.share);
  set_axes(joined(all), channels, plot);
  plot.spec.view = {panel.options<SpaceOptions>().elevation, panel.options<SpaceOptions>().azimuth};
  if (curves.empty()) return;
  if (panel.series.contains("sheets"))
    return draw_sheets(panel, recording_of(panel, recordings), channels, plot);
  if (panel.points_only) return draw_points(curves, color != nullptr, plot);
  plot.add(LineMark{space_rows(curves), {color ? "" : curve_color(0), 2.2}});
}

}  // namespace

PlotKind space_plot() {
  PlotKind kind{
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
      {{"style", "lines or points", yaml::form::word({"lines", "points"}), &Panel::points_only},
       number_key("elevation", "angle between the view and the upward axis in degrees (62)",
                  &SpaceOptions::elevation),
       number_key("azimuth", "turn of the view about the upward axis in degrees (35)",
                  &SpaceOptions::azimuth)},
      false,
      draw_space};
  kind.bar_of_channel = true;
  kind.lacks = {KeyNeeds::legend};
  return kind;
}

}  // namespace stepwire::plot
