#pragma once

#include "engine/view/plot/plot_tools.hpp"

namespace stepwire::plot {

/// Are these so many curves that lines would hide each other? Of several y or a `by` colours tell them apart.
bool are_many(const Panel& panel, const geometry::Curves& all);

/// Draws by colour through which cells how many curves go.
void draw_density(const geometry::Curves& all, PlotBuilder& plot);

}  // namespace stepwire::plot
