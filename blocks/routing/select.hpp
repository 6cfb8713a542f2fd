#pragma once

#include <vector>

#include "engine/block/declare.hpp"

namespace stepwire {

/// Chosen elements of a vector: y_k = u[indices_k], counted from 1.
struct Select {
  Eigen::VectorXd indices = Eigen::VectorXd::Ones(1);
  Input<> u{};
  Output<> y{};
  std::vector<Eigen::Index> from{};  ///< element of u for each of y, counted from 0

  void outputs() {
    for (std::size_t k = 0; k < from.size(); ++k) y.coeffRef(static_cast<Eigen::Index>(k)) = u.coeff(from[k]);
  }

  void configure(Configure& is);
  static void declare(Declare<Select>& is);
};

}  // namespace stepwire
