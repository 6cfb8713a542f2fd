#pragma once

#include <string>

namespace stepwire::render {

/// A text as gnuplot takes it literally, 'it’s': in these quotes nothing but an apostrophe has a meaning. All
/// that a diagram says goes through this, through quoted_tic() or through fitted_title().
std::string quoted(const std::string& text);
/// The same for a label at a tic, which gnuplot takes for a format of numbers.
std::string quoted_tic(const std::string& text);

/// A title, with its font, that is no wider than `room` [px]: smaller, and where that is not enough in two
/// lines.
std::string fitted_title(const std::string& text, double room);

}  // namespace stepwire::render
