#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/analyse/claim/claim.hpp"

namespace stepwire::claim {

/// Keys of the reductions, in the order of `Reduction`.
const std::vector<std::string>& reduction_names();

/// Dimension of the reduced value, where it is known.
std::optional<unit::Dimension> reduced_dimension(const Claim& claim);

/// The same of a difference of two such values, as a tolerance is: of temperatures in K, not in degC.
std::optional<unit::Dimension> difference_dimension(const Claim& claim);

/// The condition of a claim as text; `time` is the time of `at` as written.
std::string check_text(const Claim& claim, const std::string& time);

/// A reduced value with its unit: that of the comparison, else the one in which the statement has a number of
/// this kind. It has four digits and is on the same side of the comparison; where the claim does not hold, or
/// nothing of four digits is there, it has more. That of an `equals` that holds is rounded. A value below the
/// rounding of numbers of that magnitude and below 1 % of the bound is 0.
std::string value_text(const Claim& claim, double value, double magnitude = 0.0);

}  // namespace stepwire::claim
