#pragma once

#include <string>
#include <vector>

#include "blocks/records/record.hpp"
#include "blocks/sources/from_file.hpp"
#include "engine/base/table/record_table.hpp"

namespace stepwire {

/// Columns of a file in SI before their preparation, and notes for the user on changes of its rows.
struct FileRecord {
  Record record;
  std::vector<std::string> notes;
};

/// Reads columns, times and rows of a table by the parameters of a FromFile. Refuses a parameter that does
/// not fit the table.
FileRecord read_file_record(const FromFile& asked, const Configure& is, const table::RecordTable& table);

}  // namespace stepwire
