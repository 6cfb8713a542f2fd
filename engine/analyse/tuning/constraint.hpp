#pragma once

#include <vector>

#include "engine/analyse/claim/claim.hpp"
#include "engine/analyse/linear/section.hpp"

namespace stepwire::tuning {

/// Reads the claims that a tuning is subject to. A claim whose value is true or false, or whose bound leaves
/// no room, gives no margin and is a fault.
std::vector<claim::Claim> read_constraints(const yaml::Node& node,
                                           const std::vector<linear::NamedAnalysis>& linear,
                                           const query::NamesReading& read);

/// The sides of a claim, from a value: each is at least 0 where the claim holds, and infinitely negative
/// where there is no value. Two of what lies between two bounds, else one.
std::vector<double> sides_of(const claim::Comparison& comparison, double value);

/// What a margin of a claim is measured by: its bound, or its value at the start where the bound is 0.
double scale_of(const claim::Comparison& comparison, double value);

/// How far apart the ends of a claim's bounds are; infinite of one bound.
double room_of(const claim::Comparison& comparison);

}  // namespace stepwire::tuning
