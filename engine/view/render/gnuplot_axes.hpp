#pragma once

#include <string>

#include "engine/view/plot/plot_spec.hpp"

namespace stepwire::render {

/// Returns gnuplot's commands for the axes, the frame, the grid and the legend of a plot.
std::string axes_commands(const plot::PlotSpec& plot);

/// Returns the command that sets the colours of the colour axis; an empty text without one.
std::string palette_command(const plot::PlotSpec& plot);

/// Returns the commands that write texts in front of all marks.
std::string text_commands(const plot::PlotSpec& plot);

}  // namespace stepwire::render
