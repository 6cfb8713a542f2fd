#pragma once

#include "engine/view/render/render.hpp"

namespace stepwire {

/// Draws a figure whose panels are plots. Throws EnvironmentError where gnuplot is missing or fails.
Drawing render_gnuplot(const FigureSpec& figure);

/// All that gnuplot gets for such a figure.
std::string gnuplot_script(const FigureSpec& figure);

}  // namespace stepwire
