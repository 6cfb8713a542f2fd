#pragma once

#include <algorithm>

#include "engine/block/declare.hpp"
#include "engine/block/limits.hpp"

namespace stepwire {

/// Sum of its input over its ticks, as one of three approximations of an integral, within limits.
struct DiscreteIntegrator {
  enum class Method { forward_euler, backward_euler, trapezoidal };

  PerElement gain = 1.0, lower = -unlimited, upper = unlimited;
  Method method = Method::forward_euler;
  Input<> u{};
  Output<> y{};
  DiscreteState<> x{};
  Period period{};

  double before = 0.0, after = 1.0;  // shares of u T that count before and after the output is given

  void outputs() {
    for (Eigen::Index i = 0; i < y.size(); ++i) y.coeffRef(i) = sum(i);
  }

  void update() {
    for (Eigen::Index i = 0; i < x.size(); ++i) x.coeffRef(i) = sum(i) + after * increment(i);
  }

  void configure(Configure& is);
  static void declare(Declare<DiscreteIntegrator>& is);

 private:
  double increment(Eigen::Index i) const { return gain.coeff(i) * period * u.coeff(i); }
  double sum(Eigen::Index i) const {
    // The input is not read where it is not needed: it may come later in the order of evaluation.
    const double all = before == 0.0 ? x.coeff(i) : x.coeff(i) + before * increment(i);
    return std::clamp(all, lower.coeff(i), upper.coeff(i));
  }
};

}  // namespace stepwire
