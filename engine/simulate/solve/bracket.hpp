#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace stepwire::solve {

/// Result of a bracketing root search.
struct Bracket {
  double root;
  bool solved;  ///< false also if the function jumps through zero
};

/// Argument and function value.
struct Sample {
  double at, value;
};

/// Returns a point between two samples of different sign: the zero of the secant, or the midpoint if `middle`
/// is set.
inline double between(const Sample& low, const Sample& high, bool middle) {
  const double half = low.at + 0.5 * (high.at - low.at);
  if (middle) return half;
  const double secant = low.at - low.value * ((high.at - low.at) / (high.value - low.value));
  return secant > std::min(low.at, high.at) && secant < std::max(low.at, high.at) ? secant : half;
}

/// Searches for a sign change in growing distance from a number. Returns true, with both samples, if one is
/// found.
template <class May, class Function>
bool find_sign_change(double around, const May& may, const Function& function, Sample& low, Sample& high) {
  low = {around, function(around)};
  double reach = std::max({std::abs(low.value), 1e-3 * std::abs(around), 1e-9});
  const double end = 1e12 * std::max(reach, 1.0);
  for (; may() && reach < end; reach *= 4.0)
    for (const double side : {low.value, -low.value}) {
      high.at = around + std::copysign(reach, side);
      high.value = function(high.at);
      if (std::isfinite(high.value) && (high.value > 0.0) != (low.value > 0.0)) return true;
    }
  return false;
}

/// True if the function passes continuously through zero between the samples. A continuous function changes
/// more over a wider interval; a jump does not.
template <class Function>
bool is_continuous(const Sample& low, const Sample& high, const Function& function) {
  const double wide = 1024.0 * (high.at - low.at);
  const double change = std::abs(function(high.at + wide) - function(low.at - wide));
  return std::abs(high.value - low.value) <= 0.1 * change;
}

/// Finds a root of a scalar function to the last bit, by secants and bisections in turn. may() returns true
/// while evaluations are left.
template <class May, class Function>
Bracket bracket_root(double around, double tolerance, const May& may, const Function& function) {
  Sample low{}, high{};
  if (!find_sign_change(around, may, function, low, high)) return {around, false};
  bool middle = false;
  while (high.value != 0.0 && may()) {
    const double at = between(low, high, middle);
    if (at == low.at || at == high.at) break;
    middle = !middle;
    const Sample sample{at, function(at)};
    ((sample.value > 0.0) == (low.value > 0.0) ? low : high) = sample;
    if (sample.value == 0.0) return {at, true};
  }
  const Sample best = std::abs(low.value) < std::abs(high.value) ? low : high;
  const bool small = std::abs(best.value) <= tolerance * std::abs(best.at);
  return {best.at, small || (may() && is_continuous(low, high, function))};
}

}  // namespace stepwire::solve
