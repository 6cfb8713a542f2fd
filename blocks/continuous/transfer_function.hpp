#pragma once

#include "engine/block/declare.hpp"
#include "engine/block/rational.hpp"

namespace stepwire {

/// Y(s) / U(s) = numerator / denominator, proper, in controllable canonical form.
struct TransferFunction {
  Eigen::VectorXd numerator = Eigen::VectorXd::Ones(1), denominator = Eigen::VectorXd::Ones(2);
  Input<1> u{};
  Output<1> y{};
  State<> x{};

  Rational form;

  void outputs() { y = form.output(u, x); }

  void derivatives() {
    x.dot.coeffRef(0) = form.head(u, x);
    for (Eigen::Index i = 1; i < x.size(); ++i) x.dot.coeffRef(i) = x.coeff(i - 1);
  }

  void configure(Configure& is);
  static void declare(Declare<TransferFunction>& is);
};

}  // namespace stepwire
