#pragma once

#include <map>
#include <string>

#include "tests/engine/base/table/scratch.hpp"

namespace stepwire::fmu {

/// Returns the files of the unit of a diagram that is given as text, and writes NAME.yaml into the folder.
std::map<std::string, std::string> unit_files(const Scratch& folder, const std::string& name,
                                              const std::string& yaml, int version);

/// The same as NAME.fmu in the folder; its path.
std::string exported(const Scratch& folder, const std::string& name, const std::string& yaml, int version = 3);

/// True if there is a compiler; warns otherwise.
bool there_is_a_compiler();

}  // namespace stepwire::fmu
