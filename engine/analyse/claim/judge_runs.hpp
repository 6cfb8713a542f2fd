#pragma once

#include "engine/analyse/claim/claim.hpp"

namespace stepwire::claim {

/// Judges a claim about a fraction or a quantile of runs. Throws std::invalid_argument where a column is not
/// there.
void judge_runs(const Claim& claim, std::span<const record::Recording> recordings, Verdict& verdict);

}  // namespace stepwire::claim
