#pragma once

#include <string>
#include <string_view>

#include "engine/base/io/environment_error.hpp"

namespace stepwire::io {

/// Names of files of one kind: "signals.csv", "signals-2.csv", ... for the indices 0, 1, ...
std::string numbered(const std::string& stem, std::size_t index, const std::string& ending);

/// All bytes of a file. Throws EnvironmentError with the system's reason.
std::string read_file(const std::string& path);

/// Makes a folder and those above it; one that is there must take new files. Throws EnvironmentError with
/// the system's reason.
void require_folder(const std::string& path);

/// Writes to a temporary name beside `path`, then renames, so that no half file is ever seen under `path`.
/// Missing folders are made; what is no plain file ("/dev/stdout") is written as it is. Throws
/// EnvironmentError with the system's reason.
void write_file(const std::string& path, std::string_view content);
}  // namespace stepwire::io
