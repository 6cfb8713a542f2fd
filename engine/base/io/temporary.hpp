#pragma once

#include <string>

namespace stepwire::io {

/// Returns a name beside `path` that no other process or thread uses.
std::string temporary_beside(const std::string& path);

/// Throws EnvironmentError "PATH: REASON" with the system's text for this errno.
[[noreturn]] void refuse_file(const std::string& path, int reason);

}  // namespace stepwire::io
