#pragma once

#include <cstddef>
#include <stdexcept>

#include "engine/analyse/claim/claim.hpp"
#include "engine/analyse/claim/reduce.hpp"

namespace stepwire::claim {

/// Error: a claim has no value. The text holds the reason.
struct Unjudged : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Evaluates a claim's formulas on a recording. Throws Unjudged, and std::invalid_argument for a missing
/// column.
Rows rows_of(const Claim& claim, const record::Recording& recording);

/// True if `where` selects at least one row of a run.
bool selects_any(const Rows& rows, std::size_t run);

/// Returns the number of one run with at least one selected row. Throws Unjudged if it has none.
double value_of_run(const Claim& claim, const Rows& rows, std::size_t run);

}  // namespace stepwire::claim
