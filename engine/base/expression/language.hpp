#pragma once

#include <cmath>
#include <cstddef>

#include "engine/base/math/normal_quantile.hpp"

/// Functions of the language of expressions that the standard library lacks, for evaluations and for programs
/// written in C++.
namespace stepwire::language {

/// A truth as 1 or 0. In the place of double(x < y), since GCC 12 compiles 0.0 - double(x < y) as -double(x <
/// y), which is -0.0 for false.
inline double number(bool truth) {
  return truth;
}

inline double sign(double x) {
  return x > 0.0 ? 1.0 : x < 0.0 ? -1.0 : x;
}

/// The remainder with the sign of the divisor, so that an angle modulo a turn is never negative.
inline double mod(double x, double y) {
  const double rest = std::fmod(x, y);
  return rest != 0.0 && (rest < 0.0) != (y < 0.0) ? rest + y : rest;
}

/// A nan among the values is the result, whichever place it has.
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

/// min({a, b, c})
template <std::size_t count>
double min(const double (&values)[count]) {
  return smallest(values, static_cast<int>(count));
}

template <std::size_t count>
double max(const double (&values)[count]) {
  return largest(values, static_cast<int>(count));
}

/// A whole number that doubles count.
inline bool is_whole(double x) {
  return std::abs(x) < 0x1.0p53 && x == std::trunc(x);
}

/// What nobody set and is as likely anywhere, as where the zero of an encoder lies between two counts: a
/// number between 0 and 1 that depends on `seed`, which tells whose it is, and `stream`, which tells which of
/// its properties, alone. Seed and stream are whole numbers; what is none gives nan.
inline double uniform(double seed, double stream) {
  if (!is_whole(seed) || !is_whole(stream)) return std::nan("");
  // Samples of noise with the same seed are counted from 0 on; this one lies before them.
  constexpr double before_all = 0x1.0p62;
  return even_sample(static_cast<std::int64_t>(seed), static_cast<std::ptrdiff_t>(stream), before_all);
}

/// A number drawn by `seed` and `stream` as `uniform` draws them: over all seeds its mean is 0 and its
/// standard deviation 1.
inline double normal(double seed, double stream) {
  return normal_quantile(uniform(seed, stream));
}

/// What makes a value that holds for people in general that of one person: a number above 0 drawn by `seed`
/// and `stream` as `uniform` draws them. Over all seeds its logarithm is normal, its median 1, and its
/// standard deviation `variation` times its mean.
inline double lognormal(double seed, double stream, double variation) {
  return std::exp(std::sqrt(std::log1p(variation * variation)) * normal(seed, stream));
}

}  // namespace stepwire::language
