#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>

namespace stepwire {

/// The finaliser of SplitMix64 (Steele, Lea, Flood: Fast splittable pseudorandom number generators, 2014).
inline std::uint64_t mix_bits(std::uint64_t bits) {
  bits = (bits ^ (bits >> 30)) * 0xbf58476d1ce4e5b9u;
  bits = (bits ^ (bits >> 27)) * 0x94d049bb133111ebu;
  return bits ^ (bits >> 31);
}

/// Element `counter` of the SplitMix64 sequence of this seed.
inline std::uint64_t random_bits(std::uint64_t seed, std::uint64_t counter) {
  return mix_bits(seed + (counter + 1) * 0x9e3779b97f4a7c15u);
}

/// Maps bits to a uniform number in (0, 1), both ends excluded, in steps of 2^-52.
inline double to_unit_interval(std::uint64_t bits) {
  return (static_cast<double>(bits >> 12) + 0.5) * 0x1.0p-52;
}

/// Uniform number in (0, 1), hashed from seed, element of the signal and sample number alone. So a run can be
/// continued from any instant. The sample number is a double because it is counted in a state.
inline double even_sample(std::int64_t seed, std::ptrdiff_t element, double sample) {
  const std::uint64_t stream =
      random_bits(static_cast<std::uint64_t>(seed), static_cast<std::uint64_t>(element));
  return to_unit_interval(random_bits(stream, static_cast<std::uint64_t>(sample)));
}

/// Natural logarithm from correctly rounded operations only: results of libm differ between machines, those
/// of a seed must not.
inline double portable_log(double x) {
  int exponent = 0;
  double mantissa = std::frexp(x, &exponent);
  if (mantissa < 0.70710678118654752) mantissa *= 2.0, --exponent;
  const double s = (mantissa - 1.0) / (mantissa + 1.0);
  double sum = 0.0;
  for (int odd = 25; odd >= 1; odd -= 2) sum = sum * s * s + 1.0 / odd;
  return 2.0 * s * sum + exponent * 0.69314718055994530942;
}

/// Exponential function from correctly rounded operations only, to 2e-16 relative; 0 or infinity out of
/// range.
inline double portable_exp(double x) {
  if (!(x > -745.0)) return x != x ? x : 0.0;
  if (x > 709.0) return HUGE_VAL;
  const double halvings = std::floor(x * 1.44269504088896340736 + 0.5);
  const double rest =
      (x - halvings * 0x1.62e42feep-1) - halvings * 0x1.a39ef35793c76p-33;  // ln 2 in two parts
  double sum = 1.0;
  for (int n = 16; n >= 1; --n) sum = sum * rest / n + 1.0;
  return std::ldexp(sum, static_cast<int>(halvings));
}

/// Standard normal distribution function, to 1e-15, from correctly rounded operations only (Marsaglia:
/// Evaluating the normal distribution, Journal of Statistical Software 11(4), 2004).
inline double normal_probability(double x) {
  if (!(std::abs(x) < 9.0)) return x < 0.0 ? 0.0 : x > 0.0 ? 1.0 : x;
  double sum = 0.0, term = x;
  for (int odd = 1; sum != sum + term; odd += 2, term *= x * x / odd) sum += term;
  return 0.5 + sum * portable_exp(-0.5 * x * x) * 0.39894228040143267794;
}

}  // namespace stepwire
