#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "engine/base/hdf5/handle.hpp"

namespace stepwire::hdf5 {

inline constexpr std::size_t max_columns = 20'000;  // in one file

/// Opens a file for reading. Throws TableError, without the name of the file, for another format.
Handle open_file(const std::string& path);

/// Returns the names of a group's internal links, in creation order if the group has recorded it. External
/// links are left out, since they may lead to any file of the machine. Throws TableError for a damaged group.
std::vector<std::string> links_of(const Handle& group);

/// Returns the address of an object in its file. It detects several names of one group, even inside of
/// itself.
std::uint64_t place_of(const Handle& object);

/// Returns the text of an attribute; empty if it is missing or a list of texts.
std::string text_attribute(std::int64_t object, const char* name);

}  // namespace stepwire::hdf5
