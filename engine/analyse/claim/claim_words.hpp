#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/analyse/claim/claim.hpp"

namespace stepwire::claim {

/// Returns the keys of the reductions, in the order of `Reduction`.
const std::vector<std::string>& reduction_names();

/// Returns the dimension of the reduced value; std::nullopt if unknown.
std::optional<unit::Dimension> reduced_dimension(const Claim& claim);

/// Returns the dimension of a difference of two such values, e.g. of a tolerance. It differs for
/// temperatures: K, not degC.
std::optional<unit::Dimension> difference_dimension(const Claim& claim);

/// Returns the condition of a claim as text; `time` is the time of `at` as written.
std::string check_text(const Claim& claim, const std::string& time);

/// Returns a reduced value with its unit: that of the comparison, else the first fitting unit in the
/// statement. The text has four digits and is on the same side of the bound as the value. It has more digits
/// if the claim fails, or if no number of four digits is on that side. The value of an `equals` that holds is
/// rounded. A value below the rounding error of `magnitude` and below 1 % of the bound is shown as 0.
std::string value_text(const Claim& claim, double value, double magnitude = 0.0);

}  // namespace stepwire::claim
