#pragma once

#include <string>

#include "engine/figure/script.hpp"

namespace stepwire {

/// Pixels that axes take up on the screen.
struct AxesSize {
  double across = 0.0, up = 0.0;
};

/// The axes of a panel of that size, less what stands around them.
AxesSize axes_size(const Script& script, double width, double height);

/// The commands that set ticks farther apart than gnuplot does where their labels would touch; empty where
/// they do not.
std::string ticks_apart(const Script& script, const AxesSize& size);

/// A title, with its font, that is no wider than `room`: smaller, and where that is not enough in two lines.
std::string fitted_title(const std::string& text, double room);

}  // namespace stepwire
