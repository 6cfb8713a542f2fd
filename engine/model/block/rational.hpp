#pragma once

#include <string>

#include "engine/model/signal/numbers.hpp"

namespace stepwire {

/// A proper rational function of s or z in controllable canonical form, for blocks that are transfer
/// functions:
///
///     direct + (c1 p^(n-1) + ... + cn) / (p^n + a1 p^(n-1) + ... + an)
///
/// with states x where p x1 = head(u, x), p x2 = x1, ..., p xn = x(n-1).
struct Rational {
  Numbers a, c;
  double direct = 0.0;

  /// Makes it from coefficients, highest power first, which problem_of() must have accepted.
  static Rational of(const Numbers& numerator, const Numbers& denominator);

  /// Returns the problem of invalid coefficients; empty for valid ones.
  static std::string problem_of(const Numbers& numerator, const Numbers& denominator);

  Index order() const { return a.size(); }

  template <class State>
  double head(double u, const State& x) const {
    for (Index i = 0; i < a.size(); ++i) u -= a[i] * x[i];
    return u;
  }

  template <class State>
  double output(double u, const State& x) const {
    double y = c[0] * x[0];
    for (Index i = 1; i < c.size(); ++i) y += c[i] * x[i];
    // Without direct feedthrough u is not read: it may be computed later in the order of evaluation.
    return direct == 0.0 ? y : y + direct * u;
  }
};

}  // namespace stepwire
