#pragma once

#include <optional>
#include <string>

#include "engine/base/unit/unit.hpp"

namespace stepwire::unit {

// Values of one dimension that mean different things:
//
// - An angle per time (rad/s, rpm) is no number of periods per time (Hz). 1/s is either.
// - A temperature (degC, degF) is no difference of temperatures (delta_degC). K is either.

/// A complaint about a value of another meaning. An empty text if the meanings agree or one is unknown.
std::string other_meaning(const Dimension& given, const Dimension& wanted);

/// The same of a number with its unit, with the unit to write instead.
std::string other_meaning_of_number(const Dimension& given, const Dimension& wanted);

/// The factor from a value to the wanted rate, as an expression.
std::string cure_of_rate(const Dimension& wanted);

/// True for the quotient of an angle per time and a number of periods per time.
bool mixes_rates(const Dimension& quotient);

/// True for temperatures and differences of temperatures.
bool is_temperature(const Dimension& dimension);

/// Compares zeros of temperatures up to rounding.
bool are_zeros(double zeros, double wanted);

/// The zeros of a + b, or of a - b. A temperature plus K is a temperature, and K minus a temperature is
/// a difference.
std::optional<double> joined_zeros(const std::optional<double>& a, const std::optional<double>& b,
                                   bool subtracts);

}  // namespace stepwire::unit
