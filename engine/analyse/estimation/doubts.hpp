#pragma once

#include <string>
#include <vector>

#include "engine/analyse/estimation/fit.hpp"

namespace stepwire::estimation {

/// Sentences on doubtful results. A standard error is more than a hundred times its value. A record is
/// described no better than by its mean. Rows go together under standard errors that count each.
std::vector<std::string> doubts_of(const FitResult& result);

}  // namespace stepwire::estimation
