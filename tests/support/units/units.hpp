#pragma once

#include <map>
#include <string>

namespace stepwire::testing {

/// Files of a zip archive, by their paths in it.
using Entries = std::map<std::string, std::string>;

/// Writes a zip archive, and returns its path.
std::string write_zip(const std::string& path, const Entries& entries);

/// The files of a small unit: dahlquist, ball, feedthrough, stair, fails or crashes of FMI 3. Their equations
/// are in unit_of_3.cpp.
Entries unit_of_3(const std::string& kind);

/// The files of a unit of FMI 2 or 3 that does something wrong from 0.25 s on, in one of its calls: "exit DoStep". Its
/// output y is the time that it has reached. Deeds and calls: see bad_unit.cpp.
Entries bad_unit(int version, const std::string& deed);

}  // namespace stepwire::testing
