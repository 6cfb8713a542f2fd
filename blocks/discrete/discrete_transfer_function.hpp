#pragma once

#include "engine/model/block/rational.hpp"
#include "engine/model/block/resettable.hpp"

namespace stepwire {

/// Y(z) / U(z) = numerator / denominator, proper, in controllable canonical form.
struct DiscreteTransferFunction : Resettable {
  Numbers numerator{1.0}, denominator{1.0, 0.0};
  Input<1> u{};
  Output<1> y{};
  DiscreteState<> x{};

  Rational form;

  void outputs() { y = resetting() ? form.output(u, Targets{*this}) : form.output(u, x); }

  void update() {
    if (resetting()) x = Targets{*this};
    remember_reset();
    const double head = form.head(u, x);
    for (Index i = x.size() - 1; i > 0; --i) x[i] = x[i - 1];
    x[0] = head;
  }

  void configure(Configure& is);
  void start() { home = x; }
  static void declare(Declare<DiscreteTransferFunction>& is);
};

}  // namespace stepwire
