#pragma once

#include <algorithm>
#include <iterator>
#include <vector>

#include "engine/view/geometry/thinning.hpp"
#include "engine/view/plot/gather.hpp"
#include "engine/view/plot/plot_builder.hpp"
#include "engine/view/plot/plot_kind.hpp"

namespace stepwire::plot {

/// All rows of all curves as one.
geometry::Curve joined(const geometry::Curves& all);

/// Draws y over x as coloured curves, one colour for each y and each value of `by`; the legend tells them
/// apart. Many values of `by` are told apart by a colour bar instead.
void draw_curves(const Panel& panel, std::span<const record::Recording> recordings, PlotBuilder& plot);

/// Draws the curves of a group in the colour of the `entry`-th entry of the legend, thinned to `budget` rows.
void draw_group(const geometry::Curves& all, std::size_t group, std::size_t entry, std::size_t budget,
                const std::string& legend, PlotBuilder& plot);

/// A curve of numbers in the units of the axes, and its text in the legend.
struct NumberCurve {
  std::vector<double> x, y;
  std::string legend{};
};

/// Draws curves that no file gives, in the colours and with the widths of those that one does.
void draw_curves(const std::vector<NumberCurve>& curves, PlotBuilder& plot);

/// Labels an axis that no series lies along; an empty unit is none.
void name_axis(PlotAxis& axis, const std::string& label, const std::string& unit);

/// Rows that each of so many curves of a plot may have.
std::size_t rows_for(const PlotBuilder& plot, std::size_t parts);

/// Shades what lies between two lines, columns 1 and 2 of curves over column 0, below all else.
void draw_band(const std::vector<geometry::Curve>& curves, PlotBuilder& plot);

/// Shades ranges of x, whose ends stand in pairs, behind all else.
void draw_spans(const std::vector<double>& ends, PlotBuilder& plot);

/// The ranges of a plot over time or the like: x as far as the curves, y with some room.
void set_line_ranges(PlotBuilder& plot);

/// Draws how often values occur, with as many bins and with the lines that the panel gives.
void draw_histogram(const std::vector<double>& values, PlotBuilder& plot);

/// Recording of the i-th y, or of the panel.
const record::Recording& recording_of(const Panel& panel, std::span<const record::Recording> recordings,
                                      std::size_t index = 0);

}  // namespace stepwire::plot
