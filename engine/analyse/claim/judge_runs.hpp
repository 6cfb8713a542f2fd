#pragma once

#include <span>
#include <vector>

#include "engine/analyse/claim/claim.hpp"

namespace stepwire::claim {

/// Adds the numbers of the selected runs, for a claim about a fraction or a quantile of runs. Throws
/// std::invalid_argument for a missing column.
void add_numbers(const Claim& claim, std::span<const record::Recording> runs, std::vector<double>& numbers);

/// Judges such a claim on the numbers of all selected runs.
void judge_runs(const Claim& claim, const std::vector<double>& numbers, Verdict& verdict);

}  // namespace stepwire::claim
