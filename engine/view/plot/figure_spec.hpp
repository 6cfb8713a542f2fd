#pragma once

#include <deque>
#include <span>
#include <vector>

#include "engine/view/plot/figure.hpp"
#include "engine/view/plot/plot_builder.hpp"
#include "engine/view/plot/plot_spec.hpp"

namespace stepwire::plot {

/// Puts plots side by side as the title, the columns and the size of a figure have it; panels of that figure
/// do not matter.
class FigureBuilder {
 public:
  /// `count` is the number of plots, which share what a picture may hold.
  FigureBuilder(Figure figure, std::size_t count);

  /// A new plot with what its panel gives, to be drawn.
  PlotBuilder& add(Panel panel);
  /// The figure of all plots; once.
  FigureSpec finished();

 private:
  std::vector<double> row_heights(double head) const;

  Figure figure_;
  double width_, share_;  ///< of a panel
  std::deque<Panel> panels_;
  std::deque<PlotBuilder> plots_;
};

/// What is drawn of recordings.
FigureSpec figure_spec(const Figure& figure, std::span<const record::Recording> recordings);

}  // namespace stepwire::plot
