#pragma once

#include <string>

namespace stepwire::io {

/// A name beside `path` that no other process or thread uses.
std::string temporary_beside(const std::string& path);

/// Throws EnvironmentError: "PATH: what the system says to this errno".
[[noreturn]] void refuse_file(const std::string& path, int reason);

}  // namespace stepwire::io
