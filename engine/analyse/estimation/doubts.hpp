#pragma once

#include <string>
#include <vector>

#include "engine/analyse/estimation/fit.hpp"

namespace stepwire::estimation {

/// Sentences on numbers and records that a reader should not trust: a standard error of more than a hundred
/// times its value, a record that is described no better than by its mean, and rows that go together although
/// the intervals count each.
std::vector<std::string> doubts_of(const FitResult& result);

}  // namespace stepwire::estimation
