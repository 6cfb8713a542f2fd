#pragma once

#include <string>

#include "engine/base/table/record_table.hpp"

namespace stepwire {

/// The table in a .csv or .mat file, as read_record_csv and read_mat read it and with their errors;
/// TableError for other endings.
RecordTable read_data_file(const std::string& path);

}  // namespace stepwire
