#pragma once

#include "engine/model/block/block.hpp"

namespace stepwire {

/// Polynomial of each element: y = c1 u^(n-1) + c2 u^(n-2) + ..., highest power first. Even and odd powers
/// are evaluated separately by Horner's rule (Knuth, The Art of Computer Programming 2, section 4.6.4), which
/// gives two independent chains.
struct Polynomial {
  Numbers coefficients{1.0, 0.0}, hold{};
  Input<> u{};
  Output<> y{};

  void outputs() {
    y.each([&](Index k) { return at(held(u[k])); });
  }

  double at(double x) const {
    const Index count = coefficients.size();
    if (count == 1) return coefficients[0];
    const double square = x * x;
    double with_first = coefficients[0], other = coefficients[1];
    Index i = 2;
    for (; i + 1 < count; i += 2) {
      with_first = with_first * square + coefficients[i];
      other = other * square + coefficients[i + 1];
    }
    if (i == count) return with_first * x + other;
    return with_first * square + coefficients[i] + other * x;
  }

  /// Limits the argument to the range of the fit, outside of which the polynomial is invalid.
  double held(double x) const {
    if (hold.size() == 0) return x;
    const double lowest = hold[0], highest = hold[1];
    const double above = x < lowest ? lowest : x;
    return above > highest ? highest : above;
  }

  void configure(Configure& is);
  static void declare(Declare<Polynomial>& is);
};

}  // namespace stepwire
