#pragma once

#include <optional>
#include <string>

#include "engine/analyse/claim/claim.hpp"

namespace stepwire::claim {

/// Kind of the number that a reduction returns. Its unit follows from the kind and from the unit of the
/// reduced signal.
enum class ReducedKind {
  value,       ///< a value of the signal
  difference,  ///< a difference of two values, or a distance from 0
  integral,    ///< a distance from 0 times a time
  time,
  share,   ///< 1 is the whole
  number,  ///< a count or a coefficient
  percent  ///< 100 is the whole
};

/// Row of the table of all reductions: the kind of the number and its range for any input, infinite where
/// unbounded. Claims, run formulas and figures share it.
struct ReducedValue {
  ReducedKind kind;
  double least, most;
};

const ReducedValue& reduced_value(Reduction reduction);

/// Returns the dimension of the reduced number of a signal of dimension `signal`; std::nullopt if unknown.
std::optional<unit::Dimension> reduced_dimension(Reduction reduction,
                                                 const std::optional<unit::Dimension>& signal);

/// Returns the unit in which the reduced number of a signal in `signal_unit` is shown: "s", "deg s", K for a
/// difference of degC; empty for a number without unit.
std::string reduced_unit(Reduction reduction, const std::string& signal_unit);

/// Returns the unit of a difference of two values in `unit`, which differs for temperatures.
std::string unit_of_difference(const std::string& unit);

/// True for a claim whose value is a pure number and no angle, though radians have no dimension.
bool is_ratio(const Claim& claim);

}  // namespace stepwire::claim
