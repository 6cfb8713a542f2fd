#pragma once

#include <string>

#include "engine/analyse/linear/analysis.hpp"
#include "engine/analyse/linear/trim.hpp"

namespace stepwire::report {

/// A linear analysis for people: matrices with names, poles, zeros, margins, ranks and what to know of them.
std::string linear_text(const std::string& file, const linear::Analysis& analysis);

/// An operating point for people: its numbers, residuals, and whether it was found.
std::string trim_text(const std::string& file, const linear::TrimResult& result);

}  // namespace stepwire::report
