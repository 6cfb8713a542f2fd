#pragma once

#include <string>

#include "engine/base/table/record_table.hpp"

namespace stepwire::data_file {

/// The table in a .csv or .mat file, as read_record_csv and read_mat read it and with their errors;
/// TableError for other endings.
table::RecordTable read_data_file(const std::string& path);

}  // namespace stepwire::data_file
