#pragma once

#include <string>

namespace stepwire::session {

/// "0.1.0".
std::string program_version();
/// "g++ 12.2.0 -O2 ...".
std::string compiler_version();

}  // namespace stepwire::session
