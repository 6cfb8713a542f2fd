#pragma once

#include <map>
#include <string>
#include <vector>

#include "engine/app/fmu/description.hpp"

namespace stepwire::fmu {

/// Returns the source files of a unit by their paths in its folder `sources`. One of them, which contains the
/// token of `about`, is compiled and includes the others. Throws Error for blocks that cannot be generated.
std::map<std::string, std::string> unit_sources(const plan::Plan& plan, const codegen::Tuning& tuning,
                                                const UnitAbout& about,
                                                const std::vector<Variable>& variables,
                                                const std::string& no_exchange);

/// Returns the additional compiler flags of a binary that exports only the FMI functions. `folder` has the
/// sources, `header_folders` the headers of third parties in it.
std::vector<std::string> unit_flags(const std::string& folder,
                                    const std::vector<std::string>& header_folders);

}  // namespace stepwire::fmu
