#pragma once

#include <cstdint>

#include "engine/model/block/block.hpp"

namespace stepwire {

/// Adds and subtracts signals element by element: y = +-u1 +-u2 ...
struct Sum {
  Inputs u{};
  Output<> y{};
  std::uint64_t negative = 0;  ///< bit i: input i is subtracted
  Text signs{};

  void outputs() {
    if (y.size() == 1) {
      y[0] = sum_of_first_elements();
    } else {
      add_all();
    }
  }

  void configure(Configure& is);
  static void declare(Declare<Sum>& is);

 private:
  double sum_of_first_elements() const {
    const double a = u.first(0);
    if (u.count() == 1) return with_sign(0, a);
    const double b = u.first(1);
    const std::uint64_t two = negative & 3u;  // most sums have two inputs with these signs
    double sum = two == 0 ? a + b : two == 2 ? a - b : with_sign(0, a) + with_sign(1, b);
    for (Index i = 2; i < u.count(); ++i) sum += with_sign(i, u.first(i));
    return sum;
  }
  double sum_of(Index k) const {
    double sum = with_sign(0, u[0][k]);
    for (Index i = 1; i < u.count(); ++i) sum += with_sign(i, u[i][k]);
    return sum;
  }
  STEPWIRE_RARE void add_all() {
    y.each([&](Index k) { return sum_of(k); });
  }

  double with_sign(Index i, double term) const { return (negative >> i) & 1u ? -term : term; }
};

}  // namespace stepwire
