#pragma once

#include <string>
#include <string_view>

#include "engine/base/io/environment_error.hpp"

namespace stepwire::io {

/// Returns the file name of an index: "signals.csv", "signals-2.csv", ... for 0, 1, ...
std::string numbered(const std::string& stem, std::size_t index, const std::string& ending);

/// Returns all bytes of a file. Throws EnvironmentError with the system's reason.
std::string read_file(const std::string& path);

/// Creates a folder and its parents; an existing one must be writable. Throws EnvironmentError with the
/// system's reason.
void require_folder(const std::string& path);

/// Writes a temporary file beside `path` and renames it, so that no partial file is visible under `path`.
/// Missing folders are created. Special files ("/dev/stdout") are written directly. Throws EnvironmentError
/// with the system's reason.
void write_file(const std::string& path, std::string_view content);
}  // namespace stepwire::io
