#pragma once

#include <cmath>
#include <cstddef>

#include "engine/base/math/elementary.hpp"
#include "engine/base/math/normal_quantile.hpp"

/// Functions of the expression language that the standard library lacks, for the interpreter and generated
/// C++.
namespace stepwire::language {

/// Converts a truth value to 1 or 0. It replaces double(x < y), since GCC 12 compiles 0.0 - double(x < y) as
/// -double(x < y), which is -0.0 for false.
inline double number(bool truth) {
  return truth;
}

inline double sign(double x) {
  return x > 0.0 ? 1.0 : x < 0.0 ? -1.0 : x;
}

/// Remainder with the sign of the divisor, so that an angle modulo a turn is never negative.
inline double mod(double x, double y) {
  const double rest = std::fmod(x, y);
  return rest != 0.0 && (rest < 0.0) != (y < 0.0) ? rest + y : rest;
}

/// Returns the best of the values; NaN where any of them is NaN.
template <class Better>
double best(const double* values, int count, Better better) {
  double result = values[0];
  for (int i = 1; i < count; ++i) {
    if (better(values[i], result) || std::isnan(values[i])) result = values[i];
  }
  return result;
}

inline double smallest(const double* values, int count) {
  return best(values, count, [](double a, double b) { return a < b; });
}

inline double largest(const double* values, int count) {
  return best(values, count, [](double a, double b) { return a > b; });
}

/// Minimum of a list: min({a, b, c}).
template <std::size_t count>
double min(const double (&values)[count]) {
  return smallest(values, static_cast<int>(count));
}

template <std::size_t count>
double max(const double (&values)[count]) {
  return largest(values, static_cast<int>(count));
}

/// True for a whole number within the exact range of a double.
inline bool is_whole(double x) {
  return std::abs(x) < 0x1.0p53 && x == std::trunc(x);
}

/// Deterministic uniform number in (0, 1), hashed from seed and stream alone. The seed identifies an
/// individual, such as a person or specimen; the stream identifies one of its random properties, such as an
/// encoder's zero. Returns NaN where either is not a whole number.
inline double uniform(double seed, double stream) {
  if (!is_whole(seed) || !is_whole(stream)) return std::nan("");
  // Noise counts its samples from 0 with the same seed; this counter is outside of their range.
  constexpr double before_all = 0x1.0p62;
  return even_sample(static_cast<std::int64_t>(seed), static_cast<std::ptrdiff_t>(stream), before_all);
}

/// Deterministic standard normal number, drawn as by uniform().
inline double normal(double seed, double stream) {
  return normal_quantile(uniform(seed, stream));
}

/// Deterministic log-normal factor (median 1) for variation between persons. `variation` is the coefficient
/// of variation: standard deviation over mean, over all seeds.
inline double lognormal(double seed, double stream, double variation) {
  return fn::exp(std::sqrt(fn::log1p(variation * variation)) * normal(seed, stream));
}

}  // namespace stepwire::language
