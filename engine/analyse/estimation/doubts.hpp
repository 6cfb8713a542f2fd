#pragma once

#include <string>
#include <vector>

#include "engine/analyse/estimation/fit.hpp"

namespace stepwire::estimation {

/// Returns sentences on doubtful results. A standard error is more than a hundred times its value. A record
/// is described no better than by its mean. Residuals are correlated, but the standard errors assume
/// independent rows.
std::vector<std::string> doubts_of(const FitResult& result);

}  // namespace stepwire::estimation
