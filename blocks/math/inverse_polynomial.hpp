#pragma once

#include <cmath>

#include "engine/model/block/block.hpp"

namespace stepwire {

/// Inverse of a polynomial that increases over a range: p(y) = u, lower <= y <= upper.
///
/// Bisection of the range finds y to a millionth; a step with the local quadratic and a Newton step complete
/// it, within the bracket. Each call takes the same time and has no branches, so lanes can run it together.
struct InversePolynomial {
  Numbers coefficients{1.0, 0.0}, range{0.0, 1.0};
  Input<> u{};
  Output<> y{};

  void outputs() {
    y.each([&](Index k) { return argument(u[k]); });
  }

  /// Returns the value; coefficients are in descending order.
  double value(double x) const {
    double sum = 0.0;
    STEPWIRE_UNROLLED
    for (Index i = 0; i < coefficients.size(); ++i) sum = sum * x + coefficients[i];
    return sum;
  }

  double argument(double wanted) const {
    constexpr int halvings = 20;
    double low = range[0], high = range[1];
#pragma GCC unroll 20
    for (int i = 0; i < halvings; ++i) {
      const double middle = 0.5 * (low + high);
      const bool below = value(middle) < wanted;
      low = below ? middle : low;
      high = below ? high : middle;
    }
    double x = 0.5 * (low + high);
    x = between(low, x + quadratic_step(expansion(x), wanted), high);
    x = between(low, x + newton_step(expansion(x), wanted), high);
    const double at_least = wanted <= value(range[0]) ? range[0] : x;
    return wanted >= value(range[1]) ? range[1] : at_least;
  }

  void configure(Configure& is);
  static void declare(Declare<InversePolynomial>& is);

 private:
  /// Local expansion p(x + d) = value + slope d + curve d^2 + ...
  struct Expansion {
    double value = 0.0, slope = 0.0, curve = 0.0;
  };

  Expansion expansion(double x) const {
    Expansion at;
    STEPWIRE_UNROLLED
    for (Index i = 0; i < coefficients.size(); ++i) {
      at.curve = at.curve * x + at.slope;
      at.slope = at.slope * x + at.value;
      at.value = at.value * x + coefficients[i];
    }
    return at;
  }
  /// Returns the step to the root of the quadratic, in the form that is also accurate for a curve or a slope
  /// of 0.
  static double quadratic_step(const Expansion& at, double wanted) {
    const double missing = wanted - at.value, square = at.slope * at.slope + 4.0 * at.curve * missing;
    return quotient(2.0 * missing, at.slope + std::sqrt(square > 0.0 ? square : 0.0));
  }
  static double newton_step(const Expansion& at, double wanted) {
    return quotient(wanted - at.value, at.slope);
  }
  /// Returns missing / rise; 0 if the rise is not positive.
  static double quotient(double missing, double rise) {
    const double divisor = rise > 0.0 ? rise : 1.0;
    return (rise > 0.0 ? missing : 0.0) / divisor;
  }
  static double between(double low, double x, double high) {
    const double above = x > low ? x : low;
    return above < high ? above : high;
  }
};

}  // namespace stepwire
