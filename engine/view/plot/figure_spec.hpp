#pragma once

#include <deque>
#include <span>
#include <vector>

#include "engine/view/plot/figure.hpp"
#include "engine/view/plot/plot_builder.hpp"
#include "engine/view/plot/plot_spec.hpp"

namespace stepwire::plot {

/// Arranges plots with the title, columns and size of a figure; its panels are ignored.
class FigureBuilder {
 public:
  /// `count` is the number of plots, which share the budget of a picture.
  FigureBuilder(Figure figure, std::size_t count);

  /// Adds a plot with the options of its panel, to be drawn by the caller.
  PlotBuilder& add(Panel panel);
  /// Returns the figure of all plots. Call it once.
  FigureSpec finished();

 private:
  std::vector<double> row_heights(double head) const;

  Figure figure_;
  double width_, share_;  ///< of a panel
  std::deque<Panel> panels_;
  std::deque<PlotBuilder> plots_;
};

/// Returns the drawable form of a figure of recordings.
FigureSpec figure_spec(const Figure& figure, std::span<const record::Recording> recordings);

}  // namespace stepwire::plot
