#pragma once

#include "engine/view/render/render.hpp"

namespace stepwire::render {

/// Draws a figure whose panels are plots. Throws EnvironmentError if gnuplot is missing or fails.
Drawing render_gnuplot(const plot::FigureSpec& figure);

/// Returns the complete gnuplot script of such a figure.
std::string gnuplot_script(const plot::FigureSpec& figure);

}  // namespace stepwire::render
