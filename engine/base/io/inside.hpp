#pragma once

#include <string>
#include <vector>

namespace stepwire::io {

/// Name of the environment variable that lists the folders in which this process may read files of the user,
/// separated by ':'. Without it all files are readable. A server sets it for calls of others.
inline constexpr const char* inside_variable = "STEPWIRE_INSIDE";

/// True if a path is equal to a folder or below it. Links are followed in both, and the path need not exist.
bool is_below(const std::string& path, const std::string& folder);
/// True if a file is below a folder of $STEPWIRE_INSIDE or of temporary files, or if there is no such
/// variable.
bool is_inside(const std::string& path);
/// Throws EnvironmentError if a file is not inside.
void require_inside(const std::string& path);

}  // namespace stepwire::io
