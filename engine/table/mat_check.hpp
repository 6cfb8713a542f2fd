#pragma once

#include <string>

namespace stepwire {

/// Walks the outermost pieces of a MAT file of level 4 or 5 and throws TableError where they do not end with
/// the file: the library takes a file that was cut off for a shorter one and believes sizes that it reads.
/// What is inside a piece, and level 7.3, is left to the library. SurroundingsError as read_file.
void check_mat_layout(const std::string& path);

}  // namespace stepwire
