#pragma once

#include "engine/model/block/block.hpp"
#include "engine/model/block/rational.hpp"

namespace stepwire {

/// Y(s) / U(s) = numerator / denominator, proper, in controllable canonical form.
struct TransferFunction {
  Numbers numerator{1.0}, denominator{1.0, 1.0};
  Input<1> u{};
  Output<1> y{};
  State<> x{};

  Rational form;

  void outputs() { y = form.output(u, x); }

  void derivatives() {
    x.dot[0] = form.head(u, x);
    for (Index i = 1; i < x.size(); ++i) x.dot[i] = x[i - 1];
  }

  void configure(Configure& is);
  static void declare(Declare<TransferFunction>& is);
};

}  // namespace stepwire
