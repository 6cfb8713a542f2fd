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

/// Takes the columns, times and rows of a table that a FromFile asks for; refuses its parameters where the
/// table does not fit them.
FileRecord read_file_record(const FromFile& asked, const Configure& is, const table::RecordTable& table);

}  // namespace stepwire
