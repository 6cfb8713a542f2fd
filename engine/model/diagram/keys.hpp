#pragma once

#include <string>

namespace stepwire::diagram {

/// True for a valid name of a block, part, port or parameter: letters, digits and '_', not beginning with a
/// digit.
bool is_name(const std::string& text);

/// True for such names joined by dots: "rig.carriage".
bool is_dotted_name(const std::string& text);

}  // namespace stepwire::diagram
