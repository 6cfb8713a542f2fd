#pragma once

#include "engine/view/plot/plot_spec.hpp"

namespace stepwire::plot {

/// Size of axes on the screen [px].
struct AxesSize {
  double across = 0.0, up = 0.0;
};

/// Returns the size of the axes of a plot of that size, without the space for labels around them.
AxesSize axes_size(const PlotSpec& plot, double width, double height);

/// Sets the distance of ticks along all linear axes with a known range and no distance, so that their labels
/// do not overlap.
void set_steps(PlotSpec& plot, const AxesSize& size);

}  // namespace stepwire::plot
