#pragma once

#include <string>

namespace stepwire::reference {

/// Returns the example of a section. It is a whole file if it begins with `stepwire: 1`; else it replaces or
/// extends sections of the head's example.
std::string example_of(const std::string& section);

}  // namespace stepwire::reference
