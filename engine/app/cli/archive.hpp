#pragma once

#include <string>

namespace stepwire::cli {

/// Writes a tar archive of a folder to the standard output, by way of the temporary `file`.
/// Entries are sorted by name and have no times and owners, so equal files give equal bytes. Throws
/// EnvironmentError.
void put_archive(const std::string& folder, const std::string& file);

}  // namespace stepwire::cli
