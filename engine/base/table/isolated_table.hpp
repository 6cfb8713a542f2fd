#pragma once

#include <cstddef>
#include <functional>
#include <string>

#include "engine/base/table/record_table.hpp"

namespace stepwire::table {

/// Calls a function that reads a file of `file_size` bytes, in a process of its own: for files that foreign
/// code reads, which a damaged one may mislead to other memory, or to no end. Throws TableError and
/// EnvironmentError as the function does, and TableError with the name of the file where that process
/// crashes, takes longer than the time of a helper and 1 s for each 10 MB, or more memory than such a file
/// may unpack to.
RecordTable read_isolated(const std::string& path, std::size_t file_size,
                          const std::function<RecordTable()>& read);

}  // namespace stepwire::table
