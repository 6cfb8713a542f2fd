#pragma once

#include <map>
#include <string>

namespace stepwire::fmi {

/// Returns a zip archive of these files, keyed by their paths in it. The same files give the same bytes.
/// Throws UnitError.
std::string archive_bytes(const std::map<std::string, std::string>& files);

}  // namespace stepwire::fmi
