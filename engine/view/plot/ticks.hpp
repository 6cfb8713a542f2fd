#pragma once

#include "engine/view/plot/plot_spec.hpp"

namespace stepwire::plot {

/// Pixels that axes take up on the screen.
struct AxesSize {
  double across = 0.0, up = 0.0;
};

/// The axes of a plot of that size, less what stands around them.
AxesSize axes_size(const PlotSpec& plot, double width, double height);

/// Sets the distance of ticks along all linear axes of a known range that have none yet: so far apart that
/// their labels do not touch.
void set_steps(PlotSpec& plot, const AxesSize& size);

}  // namespace stepwire::plot
