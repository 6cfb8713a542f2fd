#pragma once

#include <string>
#include <vector>

#include "engine/base/table/record_table.hpp"

namespace stepwire::hdf5 {

/// Reads every real vector of an HDF5 file as a column. Its unit is the text of its attribute `units` (or
/// `unit`).
///
/// A vector in a group is named by the path, "run-1/cart.position". A matrix gives columns "name(1)",
/// "name(2)", ... by its second dimension, a compound type "name.member" for its real members. Columns may
/// differ in length. The texts of an attribute `words` are the words of a column. Any other dataset, such as
/// text, is a problem of a column without rows. External links are not followed. The library runs in a
/// process of its own. Throws TableError, with the name of the file, for another format or damage, and
/// EnvironmentError for an unreadable file.
table::RecordTable read_hdf5(const std::string& path);

/// Reads only these top-level groups, in this order. Missing groups are skipped, so the table may be empty.
table::RecordTable read_hdf5_groups(const std::string& path, const std::vector<std::string>& groups);

}  // namespace stepwire::hdf5
