#pragma once

#include <string>

#include "engine/base/csv/cell.hpp"
#include "engine/base/table/record_table.hpp"

namespace stepwire::data_file {

using csv::Decimal;

/// Reads the table in a .csv, .tsv, .txt, .dat, .mat, .h5, .hdf5 or .mcap file, as csv::read_record,
/// read_mat, read_hdf5 and read_mcap do and with their errors; TableError for other endings. The decimal mark
/// is that of text files.
table::RecordTable read_data_file(const std::string& path, Decimal decimal = Decimal::detect);

/// Is the file a text, whose rows are lines below a header?
bool has_lines(const std::string& path);

}  // namespace stepwire::data_file
