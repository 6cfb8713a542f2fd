#pragma once

#include <map>
#include <string>

namespace stepwire::testing {

/// Files of a zip archive, by their paths in it.
using Entries = std::map<std::string, std::string>;

/// Writes a zip archive, and returns its path.
std::string write_zip(const std::string& path, const Entries& entries);

/// The files of a small unit: dahlquist, ball, feedthrough, stair, fails or crashes of FMI 3. Their
/// equations stand in unit_of_3.cpp.
Entries unit_of_3(const std::string& kind);

}  // namespace stepwire::testing
