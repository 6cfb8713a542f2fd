#pragma once

#include <cmath>

/// Functions of the language of expressions that the standard library lacks. Both evaluate them: the parser,
/// and programs written in C++.
namespace stepwire::language {

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
template <int count>
double min(const double (&values)[count]) {
  return smallest(values, count);
}

template <int count>
double max(const double (&values)[count]) {
  return largest(values, count);
}

}  // namespace stepwire::language
