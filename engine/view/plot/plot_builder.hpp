#pragma once

#include <string>
#include <vector>

#include "engine/view/geometry/curve.hpp"
#include "engine/view/plot/figure.hpp"
#include "engine/view/plot/plot_spec.hpp"

namespace stepwire::plot {

/// Builder of the spec of a plot from the options of a panel.
class PlotBuilder {
 public:
  /// The panel must outlive it. The width is in pixels; the share is that of the budget of points of a
  /// picture.
  explicit PlotBuilder(const Panel& panel, double width_of_panel = 680.0, double share_of_picture = 1.0)
      : width(width_of_panel), share(share_of_picture), panel_(panel) {}

  /// Extends the plane by the first two columns of curves.
  void cover(const std::vector<geometry::Curve>& curves);
  /// Adds a mark in front of the others.
  void add(PlotMark mark) { spec.marks.push_back(std::move(mark)); }
  /// Adds a mark behind the others.
  void add_below(PlotMark mark) { spec.marks.insert(spec.marks.begin(), std::move(mark)); }

  /// Labels the axis of a channel (x, y, z, color) with the panel's text, else with its series.
  void label(const std::string& axis, const query::Series& series);
  /// Sets the range of an axis: that of the panel, else this one.
  void range(const std::string& axis, const geometry::Extent& extent);
  /// Adds a colour bar of a series with values in this extent.
  void color_bar(const query::Series& series, const geometry::Extent& extent);
  /// Sets the ranges of x and y to the covered extent, widened by a share of their widths.
  void plane(double room);

  /// Judges the marks of the plot itself: a line that is one point becomes a dot, and marks without a finite
  /// point are noted.
  void judge_marks();
  /// Returns the spec with the position of its legend. A text replaces marks that show nothing.
  PlotSpec finished();
  /// Returns a height that suits the plot [px].
  double suitable_height() const;

  const Panel& panel() const { return panel_; }

  PlotSpec spec{};
  geometry::Extent x{}, y{};  ///< covered extent; after plane() those of the axes
  double height = 0.0;        ///< height that the kind of plot needs [px]; 0: by its width
  double width, share;

 private:
  PlotAxis& axis(const std::string& name);
  std::string blank_text() const;

  const Panel& panel_;
  bool is_blank_ = false;
};

/// Diameter of dots along a line [px].
constexpr double dot_size = 4.875;

/// Space for labels and a colour bar beside the axes, and for labels below and above them [px].
constexpr double room_across = 150.0, room_up = 80.0;

/// Returns columns x and y of a curve, and as value the third column if there is one.
MarkRows plane_rows(const geometry::Curve& curve);
std::vector<MarkRows> plane_rows(const std::vector<geometry::Curve>& curves);
/// Returns columns x, y and z of curves, and as value the fourth column if there is one.
std::vector<MarkRows> space_rows(const std::vector<geometry::Curve>& curves);

/// Returns the colour of the i-th curve from a colour-blind-safe palette (Okabe and Ito).
std::string curve_color(std::size_t index);

}  // namespace stepwire::plot
