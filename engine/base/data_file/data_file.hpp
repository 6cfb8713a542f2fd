#pragma once

#include <string>

#include "engine/base/csv/cell.hpp"
#include "engine/base/table/record_table.hpp"

namespace stepwire::data_file {

using csv::Decimal;

/// Reads the table of a .csv, .tsv, .txt, .dat, .mat, .h5, .hdf5 or .mcap file. Delegates to
/// csv::read_record, read_mat, read_hdf5 and read_mcap and throws their errors; throws TableError for other
/// extensions. The decimal mark applies to text files only.
table::RecordTable read_data_file(const std::string& path, Decimal decimal = Decimal::detect);

/// True for a text file, whose rows are lines below a header.
bool has_lines(const std::string& path);

}  // namespace stepwire::data_file
