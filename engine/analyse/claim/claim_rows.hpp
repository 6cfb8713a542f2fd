#pragma once

#include <cstddef>
#include <stdexcept>

#include "engine/analyse/claim/claim.hpp"
#include "engine/analyse/claim/reduce.hpp"

namespace stepwire::claim {

/// Why a claim has no value.
struct Unjudged : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// What a claim looks at in a recording. Throws Unjudged, and std::invalid_argument where a column is not
/// there.
Rows rows_of(const Claim& claim, const record::Recording& recording);

/// Does `where` select a row of a run?
bool selects_any(const Rows& rows, std::size_t run);

/// The number of one run, of which a row is selected. Throws Unjudged where it has none.
double value_of_run(const Claim& claim, const Rows& rows, std::size_t run);

}  // namespace stepwire::claim
