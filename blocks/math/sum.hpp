#pragma once

#include <string>
#include <vector>

#include "engine/block/declare.hpp"

namespace stepwire {

/// Adds and subtracts signals element by element: y = +-u1 +-u2 ...
struct Sum {
  std::string signs{};
  Inputs u{};
  Output<> y{};
  std::vector<double> sign{};  ///< +1 or -1 for each input; multiplying by them is exact

  void start() {
    sign.assign(static_cast<std::size_t>(u.count()), 1.0);
    for (std::size_t i = 0; i < signs.size() && i < sign.size(); ++i) sign[i] = signs[i] == '-' ? -1.0 : 1.0;
  }
  void outputs() {
    const double* const s = sign.data();
    const Eigen::Index inputs = u.count();
    for (Eigen::Index k = 0; k < y.size(); ++k) {
      double sum = s[0] * u[0][k];
      for (Eigen::Index i = 1; i < inputs; ++i) sum += s[i] * u[i][k];
      y.coeffRef(k) = sum;
    }
  }

  void configure(Configure& is);
  static void declare(Declare<Sum>& is);
};

}  // namespace stepwire
