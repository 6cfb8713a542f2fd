#pragma once

#include <cstddef>
#include <string>

#include "engine/base/table/table_file.hpp"
#include "engine/simulate/replay/recorded.hpp"

namespace stepwire::replay {

/// The file of a folder that holds a recording: CSV, or HDF5 where there is no CSV. Throws Error where there
/// is neither, since what else a run writes does not have the bits of all numbers and the names of all columns.
std::string recorded_file(const std::string& folder, std::size_t recording);

/// Is it one of text, not HDF5?
bool has_lines(const std::string& file);

/// The one table of such a file, with its first signal at this column. `words` has the columns that may hold
/// words, and afterwards the words of those that do. Throws TableError, also for columns of different
/// lengths; EnvironmentError.
Recorded read_recorded(const std::string& file, std::size_t first_signal, table::ColumnWords& words);

/// Throws TableError for columns of different lengths.
void require_equal_lengths(const Recorded& recorded);

}  // namespace stepwire::replay
