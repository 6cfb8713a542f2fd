#pragma once

#include <span>

#include "engine/figure/script.hpp"

namespace stepwire {

/// Takes the discs of roses that stand at places of their own into the extent of the plane.
void cover_roses(const Panel& panel, Script& script);

/// Draws the roses of the panel: a disc whose edge stands for the largest value of all of them, a spoke for
/// each row, the line through their ends, and a line to the point where the disc stands beside it.
void draw_roses(const Panel& panel, std::span<const Recording> recordings, Script& script);

}  // namespace stepwire
