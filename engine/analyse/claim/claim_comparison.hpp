#pragma once

#include <optional>
#include <string>

#include "engine/analyse/claim/claim.hpp"

namespace stepwire::claim {

/// Reads the number on the right of a comparison, in SI. Adds a fault and returns std::nullopt if its unit
/// does not fit the value.
std::optional<double> read_compared(const yaml::Node& node, Claim& claim, const query::NamesReading& read);

/// Returns a number as written in the file; the SI unit is appended to one without a unit.
std::string written_number(const yaml::Node& node, const Claim& claim);

/// Reads both ends of `between`.
void read_between(const yaml::Node& node, Claim& claim, const query::NamesReading& read);

/// Reads the tolerance of `equals`.
void read_within(Claim& claim, const yaml::Node& node, const query::NamesReading& read);

}  // namespace stepwire::claim
