#pragma once

#include <vector>

#include "engine/analyse/claim/claim.hpp"
#include "engine/analyse/linear/request.hpp"

namespace stepwire::tuning {

/// Reads the claims that constrain an optimisation. Adds a fault for a claim without a margin: its value is
/// true or false, or its two bounds are equal.
std::vector<claim::Claim> read_constraints(const yaml::Node& node,
                                           const std::vector<linear::NamedAnalysis>& linear,
                                           const query::NamesReading& read);

/// Returns the margins of a claim at a value, one per bound: two for `between`, else one. A margin is at
/// least 0 if the claim holds, and -inf without a value.
std::vector<double> sides_of(const claim::Comparison& comparison, double value);

/// Returns the scale of a claim's margin: its bound, or the value at the start if the bound is 0.
double scale_of(const claim::Comparison& comparison, double value);

/// Returns the width of the interval between a claim's bounds; infinite for a single bound.
double room_of(const claim::Comparison& comparison);

}  // namespace stepwire::tuning
