#pragma once

#include <string>
#include <vector>

#include "blocks/records/record.hpp"
#include "blocks/sources/from_file.hpp"
#include "engine/base/table/record_table.hpp"

namespace stepwire {

/// Rows without a value that a record leaves out where they could move it against other columns of its file.
struct GapsAtEnds {
  std::string any;     ///< place of one such row; empty without one
  std::string late;    ///< refusal of a record that begins after its file; else empty
  double begin = 0.0;  ///< time of the first row before the preparation [s]
};

/// Columns of a file in SI before their preparation, and notes for the user on changes of its rows.
struct FileRecord {
  Record record;
  std::vector<std::string> notes;
  GapsAtEnds gaps;
};

/// Reads columns, times and rows of a table by the parameters of a FromFile. Refuses a parameter that does
/// not fit the table.
FileRecord read_file_record(const FromFile& asked, const Configure& is, const table::RecordTable& table);

}  // namespace stepwire
