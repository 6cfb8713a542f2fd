#pragma once

#include <string>

#include "engine/analyse/coverage/coverage.hpp"
#include "engine/view/drawing/graph.hpp"

namespace stepwire::report {

/// Returns the names of blocks in a drawing, with the branches that runs took of those that have some:
/// "limited: 1 of 2". Blocks of which all were taken have their own name.
std::map<std::string, std::string> names_with_coverage(const coverage::Coverage& coverage);

/// Returns the drawing of a diagram file, all parts opened, with these names, as SVG. Throws Error, and
/// EnvironmentError if a program for drawings is missing.
std::string coverage_picture(const Registry& registry, const std::string& file,
                             const coverage::Coverage& coverage);

}  // namespace stepwire::report
