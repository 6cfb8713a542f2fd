#pragma once

#include <string>
#include <vector>

#include "engine/base/table/record_table.hpp"

namespace stepwire::hdf5 {

/// Every real vector of an HDF5 file, one column each, with the text of its attribute `units` (or `unit`) as
/// the unit. In a group it is named with the path, "run-1/cart.position"; a matrix gives columns "name(1)",
/// "name(2)", ... by its second dimension, and the real members of a compound type "name.member". Columns may
/// differ in length; the texts of an attribute `words` are the words of a column. What else a dataset holds,
/// such as text, is a problem of a column without rows. Links that lead out of the file are not followed. The
/// library reads in a process of its own. Throws TableError, with the name of the file, for what is none or
/// is damaged, EnvironmentError where it cannot be read.
table::RecordTable read_hdf5(const std::string& path);

/// The same of these groups at the top of the file alone, in this order; one that is not there is passed
/// over, so that there may be no column at all.
table::RecordTable read_hdf5_groups(const std::string& path, const std::vector<std::string>& groups);

}  // namespace stepwire::hdf5
