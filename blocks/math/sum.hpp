#pragma once

#include <cstdint>

#include "engine/block/block.hpp"

namespace stepwire {

/// Adds and subtracts signals element by element: y = +-u1 +-u2 ...
struct Sum {
  Inputs u{};
  Output<> y{};
  std::uint64_t negative = 0;  ///< bit i: input i is subtracted
  Text signs{};

  void outputs() {
    if (y.size() == 1 && u.count() == 2) {  // most of all sums
      y[0] = with_sign(0, u.first(0)) + with_sign(1, u.first(1));
    } else {
      add_all();
    }
  }

  void prepare();
  void configure(Configure& is);
  static void declare(Declare<Sum>& is);

 private:
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
