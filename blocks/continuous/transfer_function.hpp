#pragma once

#include "engine/model/block/rational.hpp"
#include "engine/model/block/resettable.hpp"

namespace stepwire {

/// Y(s) / U(s) = numerator / denominator, proper, in controllable canonical form.
struct TransferFunction : Resettable {
  Numbers numerator{1.0}, denominator{1.0, 1.0};
  Input<1> u{};
  Output<1> y{};
  State<> x{};

  Rational form;

  void outputs() { y = form.output(u, x); }
  void outputs_at_instant() { y = resetting() ? form.output(u, Targets{*this}) : form.output(u, x); }

  void derivatives() {
    if (held()) {
      x.derivative = 0.0;
      return;
    }
    x.derivative[0] = form.head(u, x);
    for (Index i = 1; i < x.size(); ++i) x.derivative[i] = x[i - 1];
  }

  /// Runs only if something resets.
  void update() {
    if (resetting()) x = Targets{*this};
    remember_reset();
  }

  void configure(Configure& is);
  void start() { home = x; }
  static void declare(Declare<TransferFunction>& is);
};

}  // namespace stepwire
