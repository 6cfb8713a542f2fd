#pragma once

#include "engine/model/block/block.hpp"

namespace stepwire {

/// The argument at which a polynomial that rises over a range has a value: p(y) = u, lower <= y <= upper. By
/// halving the range until no number lies between its ends: each call takes as long as any other.
struct InversePolynomial {
  Numbers coefficients{1.0, 0.0}, range{0.0, 1.0};
  Input<> u{};
  Output<> y{};

  void outputs() {
    y.each([&](Index k) { return argument(u[k]); });
  }

  /// Highest power first.
  double value(double x) const {
    double sum = 0.0;
    for (Index i = 0; i < coefficients.size(); ++i) sum = sum * x + coefficients[i];
    return sum;
  }

  double argument(double wanted) const {
    constexpr int halvings = 60;
    double low = range[0], high = range[1];
    if (wanted <= value(low)) return low;
    if (wanted >= value(high)) return high;
    for (int i = 0; i < halvings; ++i) {
      const double middle = 0.5 * (low + high);
      (value(middle) < wanted ? low : high) = middle;
    }
    return 0.5 * (low + high);
  }

  void configure(Configure& is);
  static void declare(Declare<InversePolynomial>& is);
};

}  // namespace stepwire
