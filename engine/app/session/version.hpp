#pragma once

#include <string>

namespace stepwire::session {

/// Returns the version of the program, "0.1.0".
std::string program_version();
/// Returns compiler, version and flags, "g++ 12.2.0 -O2 ...".
std::string compiler_version();

}  // namespace stepwire::session
