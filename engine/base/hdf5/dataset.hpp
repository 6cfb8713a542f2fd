#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

#include "engine/base/table/record_table.hpp"

namespace stepwire::hdf5 {

/// Appends the columns of a dataset to the table; its numbers take their bytes from the budget. What is none
/// of numbers, or not to be read, is a problem of a column without rows. Throws TableError, without the name
/// of the file, where it is damaged or the budget is spent.
void read_dataset(std::int64_t set, const std::string& name, table::RecordTable& table, std::size_t& budget);

}  // namespace stepwire::hdf5
