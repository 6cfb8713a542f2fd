#pragma once

#include <string>

namespace stepwire::render {

/// Returns a text as a literal of gnuplot, 'it’s': in single quotes only an apostrophe is special. All texts
/// of a diagram must pass through this, quoted_tic() or fitted_title().
std::string quoted(const std::string& text);
/// Returns the same for the label of a tick, which gnuplot interprets as a format of numbers.
std::string quoted_tic(const std::string& text);

/// Returns a title, with its font, that is at most `room` wide [px]: in a smaller font, and if needed in two
/// lines.
std::string fitted_title(const std::string& text, double room);

}  // namespace stepwire::render
