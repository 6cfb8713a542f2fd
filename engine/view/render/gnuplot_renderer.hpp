#pragma once

#include "engine/view/render/render.hpp"

namespace stepwire::render {

/// Draws a figure whose panels are plots. Throws EnvironmentError where gnuplot is missing or fails.
Drawing render_gnuplot(const plot::FigureSpec& figure);

/// All that gnuplot gets for such a figure.
std::string gnuplot_script(const plot::FigureSpec& figure);

}  // namespace stepwire::render
