#pragma once

#include <cstddef>
#include <string>

#include "engine/base/table/table_file.hpp"
#include "engine/simulate/replay/recorded.hpp"

namespace stepwire::replay {

/// Returns the file of a folder that holds a recording: CSV, or HDF5 if there is no CSV. Throws Error without
/// either, since other formats do not have all bits and column names.
std::string recorded_file(const std::string& folder, std::size_t recording);

/// True for a text file, false for HDF5.
bool has_lines(const std::string& file);

/// Reads the table of such a file, with its first signal at this column. On entry `words` has the columns
/// that may hold words, on return the words of those that do. Throws TableError, also for columns of
/// different lengths; EnvironmentError.
Recorded read_recorded(const std::string& file, std::size_t first_signal, table::ColumnWords& words);

/// Throws TableError for columns of different lengths.
void require_equal_lengths(const Recorded& recorded);

}  // namespace stepwire::replay
