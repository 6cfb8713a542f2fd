#pragma once

#include <string>

#include "engine/base/table/record_table.hpp"

namespace stepwire::data_file {

/// The table in a .csv, .mat, .h5, .hdf5 or .mcap file, as read_record_csv, read_mat, read_hdf5 and read_mcap
/// read it and with their errors; TableError for other endings.
table::RecordTable read_data_file(const std::string& path);

/// Is the file a text, whose rows are lines below a header?
bool has_lines(const std::string& path);

}  // namespace stepwire::data_file
