#pragma once

#include <map>
#include <string>

#include "tests/engine/base/table/scratch.hpp"

namespace stepwire::fmu {

/// The files of a unit of a diagram that is given as text; it stands in the folder as NAME.yaml.
std::map<std::string, std::string> unit_files(const Scratch& folder, const std::string& name,
                                              const std::string& yaml, int version);

/// The same as NAME.fmu in the folder; its path.
std::string exported(const Scratch& folder, const std::string& name, const std::string& yaml, int version = 3);

/// Is there a compiler? Warns where there is none.
bool there_is_a_compiler();

}  // namespace stepwire::fmu
