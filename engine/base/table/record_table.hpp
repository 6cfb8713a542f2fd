#pragma once

#include <map>
#include <string>
#include <vector>

#include "engine/base/table/table.hpp"

namespace stepwire::table {

/// A table as other programs and people leave it.
struct RecordTable : Table {
  std::map<std::string, std::string>
      problems{};  ///< by column: its first cell that is no number, with its place
  std::map<std::string, std::vector<std::string>>
      words{};  ///< by column: what its numbers 0, 1, ... stand for, where an HDF5 file says so
};

/// A CSV file, read as by read_csv and with its errors; but a cell that is a text or empty is nan and a
/// problem of its column, and columns without a name, as that of trailing commas, and empty rows at the end
/// are left out.
RecordTable read_record_csv(const std::string& path);

}  // namespace stepwire::table
