#pragma once

#include <string>
#include <vector>

#include "engine/base/table/record_table.hpp"

namespace stepwire::data_file {

/// Reads the recorded signals of a run: a data file, or a folder of `run --out` with a table for each period.
/// Of several kinds of files there, h5 is read before csv and mat. Throws TableError, also for a folder
/// without signals and for a missing file.
std::vector<table::RecordTable> read_recorded_run(const std::string& path);

}  // namespace stepwire::data_file
