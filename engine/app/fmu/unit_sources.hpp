#pragma once

#include <map>
#include <string>
#include <vector>

#include "engine/app/fmu/description.hpp"

namespace stepwire::fmu {

/// Files of the sources of a unit, by their paths in its folder `sources`. One of them is compiled and
/// includes what it needs of the others; the token of `about` stands in it. Throws Error for what cannot be
/// generated.
std::map<std::string, std::string> unit_sources(const plan::Plan& plan, const codegen::Tuning& tuning,
                                                const UnitAbout& about,
                                                const std::vector<Variable>& variables,
                                                const std::string& no_exchange);

/// The options, besides those of every generated code, with which a binary shows nothing but the functions of
/// FMI and needs no library of the compiler; the sources lie in `folder`, with these folders for headers of
/// others.
std::vector<std::string> unit_flags(const std::string& folder,
                                    const std::vector<std::string>& header_folders);

}  // namespace stepwire::fmu
