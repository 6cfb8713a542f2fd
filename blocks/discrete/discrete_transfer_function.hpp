#pragma once

#include "engine/block/declare.hpp"
#include "engine/block/rational.hpp"

namespace stepwire {

/// Y(z) / U(z) = numerator / denominator, proper, in controllable canonical form.
struct DiscreteTransferFunction {
  Eigen::VectorXd numerator = Eigen::VectorXd::Ones(1), denominator = Eigen::Vector2d(1.0, 0.0);
  Input<1> u{};
  Output<1> y{};
  DiscreteState<> x{};

  Rational form;

  void outputs() { y = form.output(u, x); }

  void update() {
    const double head = form.head(u, x);
    for (Eigen::Index i = x.size() - 1; i > 0; --i) x.coeffRef(i) = x.coeff(i - 1);
    x.coeffRef(0) = head;
  }

  void configure(Configure& is);
  static void declare(Declare<DiscreteTransferFunction>& is);
};

}  // namespace stepwire
