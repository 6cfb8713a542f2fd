#pragma once

#include <string>

namespace stepwire::session {

/// Returns the version of the program, which CMakeLists.txt has: "major.minor.patch".
std::string program_version();
/// Returns compiler and flags of the program: "g++ 12.2.0 -O2 ...".
std::string compiler_version();

}  // namespace stepwire::session
