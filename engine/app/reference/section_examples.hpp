#pragma once

#include <string>

namespace stepwire::reference {

/// The example of a section: a whole file where it begins with `stepwire: 1`, else what is added to that of
/// the head in place of what is there.
std::string example_of(const std::string& section);

}  // namespace stepwire::reference
