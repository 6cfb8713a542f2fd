#pragma once

#include <cstdint>
#include <string>

#include "engine/block/block.hpp"

namespace stepwire {

/// Adds and subtracts signals element by element: y = +-u1 +-u2 ...
struct Sum {
  Inputs u{};
  Output<> y{};
  std::uint64_t negative = 0;  ///< bit i: input i is subtracted
  std::string signs{};

  void prepare();
  void outputs() {
    for (Index k = 0; k < y.size(); ++k) {
      double sum = term(0, k);
      for (Index i = 1; i < u.count(); ++i) sum += term(i, k);
      y[k] = sum;
    }
  }

  void configure(Configure& is);
  static void declare(Declare<Sum>& is);

 private:
  double term(Index i, Index k) const { return (negative >> i) & 1u ? -u[i][k] : u[i][k]; }
};

}  // namespace stepwire
