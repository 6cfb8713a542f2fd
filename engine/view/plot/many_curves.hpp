#pragma once

#include "engine/view/plot/plot_tools.hpp"

namespace stepwire::plot {

/// True for a number of curves at which lines would hide each other. False with several y or a `by`, whose
/// curves are distinguished by colour.
bool are_many(const Panel& panel, const geometry::Curves& all);

/// Draws the number of curves through each cell as a colour.
void draw_density(const geometry::Curves& all, PlotBuilder& plot);

}  // namespace stepwire::plot
