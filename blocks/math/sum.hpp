#pragma once

#include <cstdint>
#include <string>

#include "engine/block/declare.hpp"

namespace stepwire {

/// Adds and subtracts signals element by element: y = +-u1 +-u2 ...
struct Sum {
  Inputs u{};
  Output<> y{};
  std::uint64_t negative = 0;  ///< bit i: input i is subtracted
  std::string signs{};

  void start() {
    negative = 0;
    for (std::size_t i = 0; i < signs.size(); ++i) negative |= std::uint64_t{signs[i] == '-'} << i;
  }
  void outputs() {
    for (Eigen::Index k = 0; k < y.size(); ++k) {
      double sum = term(0, k);
      for (Eigen::Index i = 1; i < u.count(); ++i) sum += term(i, k);
      y.coeffRef(k) = sum;
    }
  }

  void configure(Configure& is);
  static void declare(Declare<Sum>& is);

 private:
  double term(Eigen::Index i, Eigen::Index k) const { return (negative >> i) & 1u ? -u[i][k] : u[i][k]; }
};

}  // namespace stepwire
