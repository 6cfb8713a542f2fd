#pragma once

#include <string>

#include "engine/app/difference/difference.hpp"

namespace stepwire::difference {

/// Returns one drawing of two diagram files as SVG. New, gone and changed blocks and wires have a colour, a
/// sign and a stroke of their own; below it are a legend and the changes in words. Throws yaml::Error for a
/// diagram with faults, EnvironmentError if node or elkjs is missing.
std::string difference_picture(const Registry& registry, const std::string& before, const std::string& after,
                               const Difference& difference);

}  // namespace stepwire::difference
