#pragma once

#include "engine/block/block.hpp"

namespace stepwire {

/// A polynomial of each element by Horner's rule: y = (c1 u + c2) u + c3 ..., highest power first.
struct Polynomial {
  Numbers coefficients{1.0, 0.0}, hold{};
  Input<> u{};
  Output<> y{};

  void outputs() {
    y.each([&](Index k) { return at(held(u[k])); });
  }

  double at(double x) const {
    double sum = coefficients[0];
    for (Index i = 1; i < coefficients.size(); ++i) sum = sum * x + coefficients[i];
    return sum;
  }

  /// A fit says nothing outside of what it was fitted to.
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
