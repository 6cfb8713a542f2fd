#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "engine/base/hdf5/handle.hpp"

namespace stepwire::hdf5 {

inline constexpr std::size_t max_columns = 20'000;  // of a file

/// Opens a file to read it. Throws TableError, without the name of the file, where it is no HDF5 file.
Handle open_file(const std::string& path);

/// Names of the links of a group into this file, in the order in which they were made where the group has
/// kept it. Others may lead to any file of the machine. Throws TableError for a damaged group.
std::vector<std::string> links_of(const Handle& group);

/// Address of an object in its file: one group may have several names, also one inside of itself.
std::uint64_t place_of(const Handle& object);

/// Text of an attribute; empty without such an attribute, and for a list of texts.
std::string text_attribute(std::int64_t object, const char* name);

}  // namespace stepwire::hdf5
