#pragma once

#include <optional>
#include <string>

#include "engine/base/unit/unit.hpp"

namespace stepwire::unit {

// Distinguishes values of one dimension with different meanings:
//
// - An angle per time (rad/s, rpm) is no number of periods per time (Hz). 1/s is either.
// - A temperature (degC, degF) is no difference of temperatures (delta_degC). K is either.
// - A factor with degC in it (W/degC) is one of differences. With K in it (W/K) it is one of either.

/// Returns a complaint about a value of another meaning; empty if the meanings agree or one is unknown.
std::string other_meaning(const Dimension& given, const Dimension& wanted);

/// Returns the complaint about a number with its unit, and the unit to write instead.
std::string other_meaning_of_number(const Dimension& given, const Dimension& wanted);

/// Returns the SI unit as a text that parse_unit reads back with its meaning: "temperature_K" for degC,
/// "W/delta_degC" for W/degC.
std::string meaning_name(const Dimension& dimension);

/// Returns the conversion of a value with angles to one with periods or back: "divide by 2*pi".
std::string cure_of_rate(const Dimension& given, const Dimension& wanted);

/// True for the quotient of an angle per time and a number of periods per time.
bool mixes_rates(const Dimension& quotient);

/// True for temperatures and differences of temperatures.
bool is_temperature(const Dimension& dimension);

/// Returns the complaint about a temperature with these zeros times a factor of differences, such as W/degC;
/// empty for a difference. A temperature in degC has another zero than one in K, so the product is none.
std::string refused_product(const std::optional<double>& zeros, const Dimension& factor);

/// True where two zeros of temperature scales are equal up to rounding.
bool are_zeros(double zeros, double wanted);

/// Returns the zeros of a + b or a - b. A temperature plus K is a temperature; K minus a temperature is a
/// difference.
std::optional<double> joined_zeros(const std::optional<double>& a, const std::optional<double>& b,
                                   bool subtracts);

}  // namespace stepwire::unit
