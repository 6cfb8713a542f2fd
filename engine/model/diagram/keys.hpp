#pragma once

#include <string>

namespace stepwire::diagram {

/// Is this a name that a block, part, port or parameter may have? Letters, digits and '_', not beginning with
/// a digit.
bool is_name(const std::string& text);

/// Such names with dots between them: "rig.carriage".
bool is_dotted_name(const std::string& text);

}  // namespace stepwire::diagram
