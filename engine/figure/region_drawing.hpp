#pragma once

#include "engine/figure/figure.hpp"
#include "engine/figure/script.hpp"

namespace stepwire {

/// Has the axes of a plane show the regions; before anything else is drawn.
void cover_regions(const Panel& panel, Script& script);

/// Draws the boundaries of the regions above all else, and shades the inside of those of a plane below it.
void draw_regions(const Panel& panel, Script& script);

}  // namespace stepwire
