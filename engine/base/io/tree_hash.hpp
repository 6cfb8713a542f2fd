#pragma once

#include <cstddef>
#include <string>

namespace stepwire::io {

/// Content of a folder.
struct TreeHash {
  std::string sha256;     ///< 64 hexadecimal digits
  std::size_t files = 0;  ///< number of files and links
};

/// Returns the hash of all files below a folder. It is the SHA-256 of a list that has for each file its path,
/// a zero byte, the SHA-256 of its content in hexadecimal digits, and a line end. The list is in the order of
/// the bytes of the paths. A symbolic link is a file whose content is "link:" and its target. Modes and times
/// do not count. Throws EnvironmentError for an unreadable folder, and for what is neither file, folder nor
/// link.
TreeHash tree_hash(const std::string& folder);

/// Returns the same hash. Later calls of a process read no content while each file has the path, number,
/// size and times of change that it had when it was hashed. The system sets the time of change at each change
/// of content, and no program can set it back. Files that changed less than two seconds before they were
/// hashed are hashed again. Thread-safe.
std::string known_tree_hash(const std::string& folder);

}  // namespace stepwire::io
