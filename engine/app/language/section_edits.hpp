#pragma once

#include <string>

#include "engine/app/language/edits.hpp"
#include "engine/app/language/tree_edits.hpp"

namespace stepwire::language {

/// Adds an analysis to `linear` and its Bode plot to `figure`, and returns the name of the analysis.
std::string cut_loop(TreeEdits& edits, const yaml::Document& document, const CutLoop& edit);

}  // namespace stepwire::language
