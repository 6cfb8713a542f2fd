#pragma once

#include <map>
#include <string>

namespace stepwire::fmi {

/// A zip archive of these files, by their paths in it: the same files give the same bytes. Throws UnitError.
std::string archive_bytes(const std::map<std::string, std::string>& files);

}  // namespace stepwire::fmi
