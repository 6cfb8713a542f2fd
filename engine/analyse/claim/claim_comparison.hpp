#pragma once

#include <optional>
#include <string>

#include "engine/analyse/claim/claim.hpp"

namespace stepwire::claim {

/// The number that a claim's value is held against, in SI; nothing, and a fault, where it does not fit the
/// value.
std::optional<double> read_compared(const yaml::Node& node, Claim& claim, const query::NamesReading& read);

/// A number as it is written, with the SI unit that one without a unit has.
std::string written_number(const yaml::Node& node, const Claim& claim);

/// Reads the two ends of `between`.
void read_between(const yaml::Node& node, Claim& claim, const query::NamesReading& read);

/// Reads the tolerance of `equals`.
void read_within(Claim& claim, const yaml::Node& node, const query::NamesReading& read);

}  // namespace stepwire::claim
