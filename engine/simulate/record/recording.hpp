#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "engine/base/table/table.hpp"

namespace stepwire::record {

/// Swept parameter whose values are words (or files); its column holds indices 0, 1, ... of these texts.
struct Categories {
  std::string column;
  std::vector<std::string> texts;
};

/// Recording of one record entry of a run, or of all runs of a sweep. Columns of equal length: "time" first
/// (unit s), then swept parameters, then signals. All numbers are SI.
struct Recording {
  table::Table table;
  std::vector<std::size_t> starts{0};  ///< first row of each run; one element 0 for a single run
  std::vector<Categories> categories;
};

}  // namespace stepwire::record
