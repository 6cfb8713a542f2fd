#pragma once

#include <string>
#include <vector>

#include "blocks/records/record.hpp"
#include "blocks/sources/from_file.hpp"
#include "engine/base/table/record_table.hpp"

namespace stepwire {

/// Columns of a file in SI before they are prepared, and for people what was done to its rows.
struct FileRecord {
  Record record;
  std::vector<std::string> notes;
};

/// Takes columns, times and rows of a table by the parameters of a FromFile. Refuses a parameter that does
/// not fit the table.
FileRecord read_file_record(const FromFile& asked, const Configure& is, const table::RecordTable& table);

}  // namespace stepwire
