#pragma once

#include "tests/random/values.hpp"

namespace stepwire::random {

/// Numbers of usual size.
std::vector<double> some(Making& making, Index count);
/// "[1, 2]", for one number, too.
std::string list(const std::vector<double>& numbers);
/// Numbers in the unit of a unit variable, such as "'u".
std::string in_unit(Making& making, const std::string& numbers, const char* unit_variable);
/// A rate of which a run shows four times the time [1/s].
double slowest(Making& making);
/// No value: the default holds.
std::string without(Making& making);

template <int first, int last>
std::string whole(Making& making) {
  return std::to_string(making.dice().whole(first, last));
}

/// Values of models, filters, sources, plants and devices, a part of special_values().
const std::map<std::string, SpecialValue>& model_values();

}  // namespace stepwire::random
