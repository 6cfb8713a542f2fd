#pragma once

#include <span>

#include "engine/figure/script.hpp"

namespace stepwire {

/// Takes the motions of the panel into the extent of the plane.
void cover_motions(const Panel& panel, std::span<const Recording> recordings, Script& script);

/// Draws the motions of the panel as lines below its curves, with arrow heads at even distances along each.
void draw_motions(const Panel& panel, std::span<const Recording> recordings, Script& script);

}  // namespace stepwire
