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

/// A reduced value with its unit: in the author's unit where the claim has one. The number has four digits;
/// more where a rounded one would be on the other side of the condition, except in an `equals` that holds. A
/// value below the resolution of numbers of that magnitude, and of the condition, is 0.
std::string value_text(const Claim& claim, double value, double magnitude = 0.0);

}  // namespace stepwire::claim
