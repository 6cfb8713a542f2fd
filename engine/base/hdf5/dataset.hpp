#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

#include "engine/base/table/record_table.hpp"

namespace stepwire::hdf5 {

/// Appends the columns of a dataset to the table, and subtracts their bytes from the budget. Non-numeric or
/// unreadable data become a problem of a column without rows. Throws TableError, without the name of the
/// file, for a damaged dataset or an exhausted budget.
void read_dataset(std::int64_t set, const std::string& name, table::RecordTable& table, std::size_t& budget);

}  // namespace stepwire::hdf5
