#pragma once

#include <string>

#include "engine/analyse/linear/analysis.hpp"
#include "engine/analyse/linear/trim.hpp"

namespace stepwire::report {

/// Returns a linear analysis as text: matrices with names, poles, zeros, margins, ranks and notes.
std::string linear_text(const linear::Analysis& analysis);

/// Returns an operating point as text: its numbers, residuals, and whether it was found.
std::string trim_text(const linear::TrimResult& result);

}  // namespace stepwire::report
