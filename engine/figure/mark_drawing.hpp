#pragma once

#include "engine/figure/script.hpp"

namespace stepwire {

/// Size of the area between the axes of a panel, in pixels.
struct PlotArea {
  double width = 0.0, height = 0.0;
};

/// Takes the marks and texts of the panel into the extent of the plane.
void cover_marks(const Panel& panel, Script& script);

/// Draws the marks with their names on top of all that is drawn, each name on that side of its point where it
/// covers least of the curves, of the other marks and of the frame. The ranges of both axes are known by now.
void draw_marks(const Panel& panel, const PlotArea& area, Script& script);

/// Writes the texts of the panel, each with its middle at its point, in front of all that is drawn.
void draw_texts(const Panel& panel, Script& script);

}  // namespace stepwire
