#pragma once

#include <cstddef>
#include <functional>
#include <string>

#include "engine/base/table/record_table.hpp"

namespace stepwire::table {

/// Runs a reader of a file of `file_size` bytes in a process of its own. Foreign libraries may corrupt memory
/// or loop for ever on a damaged file. Throws TableError and EnvironmentError as the reader does. Throws
/// TableError, with the name of the file, where the process crashes or exceeds its limits. The time limit is
/// that of helper programs and 1 s for each 10 MB; memory is bounded by max_unpacked().
RecordTable read_isolated(const std::string& path, std::size_t file_size,
                          const std::function<RecordTable()>& read);

}  // namespace stepwire::table
