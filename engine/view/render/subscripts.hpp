#pragma once

#include <string>

namespace stepwire::render {

/// Returns the text of a label as SVG with subscripts: "force F_e [N]" has a small e. A quantity is one or
/// two capitals and an index of one to three letters or digits, not adjacent to a letter, digit, dot or
/// underscore.
std::string with_subscripts(const std::string& label);

/// Sets the subscripts of all texts in a picture of gnuplot.
void set_subscripts(std::string& svg);

}  // namespace stepwire::render
