#pragma once

#include <string>
#include <vector>

#include "engine/view/geometry/curve.hpp"
#include "engine/view/geometry/extent.hpp"
#include "engine/view/plot/figure.hpp"
#include "engine/view/plot/plot_spec.hpp"

namespace stepwire::plot {

/// The spec of a plot while it is put together from what a panel of a file, or a program, gives.
class PlotBuilder {
 public:
  /// The panel has to outlive it. The width is in pixels; the share is that of the points that a picture may
  /// have.
  explicit PlotBuilder(const Panel& panel, double width_of_panel = 680.0, double share_of_picture = 1.0)
      : width(width_of_panel), share(share_of_picture), panel_(panel) {}

  /// Takes the first two columns of curves into the extent of the plane.
  void cover(const std::vector<geometry::Curve>& curves);
  /// Adds a mark in front of the others.
  void add(PlotMark mark) { spec.marks.push_back(std::move(mark)); }
  /// Adds a mark below the others.
  void add_below(PlotMark mark) { spec.marks.insert(spec.marks.begin(), std::move(mark)); }

  /// Labels the axis of a channel (x, y, z, color) with the panel's text, else with its series.
  void label(const std::string& axis, const query::Series& series);
  /// Sets the range of an axis: the panel's, or this.
  void range(const std::string& axis, const geometry::Extent& extent);
  /// Colour bar of a series whose values lie in this extent.
  void color_bar(const query::Series& series, const geometry::Extent& extent);
  /// Ranges of x and y around what is covered, widened by a share of their widths.
  void plane(double room);

  /// The spec with the place of its legend; without marks it says that there are no rows.
  PlotSpec finished();
  /// Height that suits the plot [px].
  double suitable_height() const;

  const Panel& panel() const { return panel_; }

  PlotSpec spec{};
  geometry::Extent x{}, y{};  ///< of what is covered; those of the axes behind plane()
  double height = 0.0;        ///< that the kind of plot needs [px]; 0: by its width
  double width, share;

 private:
  PlotAxis& axis(const std::string& name);

  const Panel& panel_;
};

/// Pixels for labels and a colour bar beside the axes, and for labels below and above them.
constexpr double room_across = 150.0, room_up = 80.0;

/// Columns x and y of a curve, and behind them the value if there is a third.
MarkRows plane_rows(const geometry::Curve& curve);
std::vector<MarkRows> plane_rows(const std::vector<geometry::Curve>& curves);
/// Columns x, y and z of curves, and behind them the value if there is a fourth.
std::vector<MarkRows> space_rows(const std::vector<geometry::Curve>& curves);

/// Colour of the i-th curve, which colour-blind people distinguish as well (Okabe and Ito).
std::string curve_color(std::size_t index);

}  // namespace stepwire::plot
