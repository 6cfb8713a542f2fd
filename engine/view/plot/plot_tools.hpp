#pragma once

#include <iterator>
#include <optional>
#include <vector>

#include "engine/view/geometry/thinning.hpp"
#include "engine/view/plot/gather.hpp"
#include "engine/view/plot/plot_builder.hpp"
#include "engine/view/plot/plot_kind.hpp"

namespace stepwire::plot {

enum class CurveStyle { line, dashes, dots };

/// Options of plots with curves.
struct CurveOptions {
  std::vector<CurveStyle> styles{};  ///< in the order of the legend
  std::vector<double> shade{};       ///< ends of shaded ranges of x, in pairs
};

/// Options of histograms.
struct HistogramOptions {
  double bins = 30.0;
  std::vector<double> lines{};             ///< values at which a line is drawn
  std::optional<std::size_t> reduction{};  ///< in claim::reduction_names(); std::nullopt: rows
};

/// Returns all rows of all curves as one curve.
geometry::Curve joined(const geometry::Curves& all);

/// Draws y over x, with a colour for each y and each value of `by` and a legend. Many values of `by` have a
/// colour bar instead.
void draw_curves(const Panel& panel, std::span<const record::Recording> recordings, PlotBuilder& plot);

/// Draws the curves of a group in the colour of the `entry`-th entry of the legend, thinned to `budget` rows.
void draw_group(const geometry::Curves& all, std::size_t group, std::size_t entry, std::size_t budget,
                const std::string& legend, PlotBuilder& plot);

/// Curve of numbers in the units of the axes, and its text in the legend.
struct NumberCurve {
  std::vector<double> x, y;
  std::string legend{};
};

/// Draws curves that are not from a file, in the same colours and widths.
void draw_curves(const std::vector<NumberCurve>& curves, PlotBuilder& plot);

/// Labels an axis without a series; the unit may be empty.
void name_axis(PlotAxis& axis, const std::string& label, const std::string& unit);

/// Shades the area between two lines, columns 1 and 2 of curves over column 0, behind everything else.
void draw_band(const std::vector<geometry::Curve>& curves, PlotBuilder& plot);

/// Shades ranges of x, given as pairs of ends, behind everything else.
void draw_spans(const std::vector<double>& ends, PlotBuilder& plot);

/// Sets the ranges of a plot over time or similar: x to the extent of the curves, y with a margin.
void set_line_ranges(PlotBuilder& plot);

/// Draws a histogram of values with the HistogramOptions of the panel.
void draw_histogram(const std::vector<double>& values, PlotBuilder& plot);

/// Returns the recording of the i-th y, or of the panel.
const record::Recording& recording_of(const Panel& panel, std::span<const record::Recording> recordings,
                                      std::size_t index = 0);

}  // namespace stepwire::plot
