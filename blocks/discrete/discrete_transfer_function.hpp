#pragma once

#include "engine/model/block/block.hpp"
#include "engine/model/block/rational.hpp"

namespace stepwire {

/// Y(z) / U(z) = numerator / denominator, proper, in controllable canonical form.
struct DiscreteTransferFunction {
  Numbers numerator{1.0}, denominator{1.0, 0.0};
  Input<1> u{};
  Output<1> y{};
  DiscreteState<> x{};

  Rational form;

  void outputs() { y = form.output(u, x); }

  void update() {
    const double head = form.head(u, x);
    for (Index i = x.size() - 1; i > 0; --i) x[i] = x[i - 1];
    x[0] = head;
  }

  void configure(Configure& is);
  static void declare(Declare<DiscreteTransferFunction>& is);
};

}  // namespace stepwire
