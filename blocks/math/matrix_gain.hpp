#pragma once

#include "engine/block/declare.hpp"

namespace stepwire {

/// A matrix times a vector: y = gain u.
struct MatrixGain {
  Eigen::MatrixXd gain = Eigen::MatrixXd::Identity(1, 1);
  Input<> u{};
  Output<> y{};

  void outputs() {
    for (Eigen::Index row = 0; row < y.size(); ++row) {
      double sum = gain.coeff(row, 0) * u.coeff(0);
      for (Eigen::Index column = 1; column < u.size(); ++column)
        sum += gain.coeff(row, column) * u.coeff(column);
      y.coeffRef(row) = sum;
    }
  }

  static void declare(Declare<MatrixGain>& is);
};

}  // namespace stepwire
