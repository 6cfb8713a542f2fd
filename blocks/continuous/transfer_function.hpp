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

  void outputs() { show(held()); }
  void outputs_at_instant() { show(resetting()); }

  void derivatives() {
    if (held()) {
      x.derivative = 0.0;
      return;
    }
    x.derivative[0] = form.head(u, x);
    for (Index i = 1; i < x.size(); ++i) x.derivative[i] = x[i - 1];
  }

  void update_before_instant() { follow_target(x); }
  /// Runs only if something resets.
  void update() {
    if (resetting()) x = Targets{*this};
    remember_reset();
  }

  void configure(Configure& is);
  void start() { home = x; }
  static void declare(Declare<TransferFunction>& is);

 private:
  void show(bool at_target) { y = at_target ? form.output(u, Targets{*this}) : form.output(u, x); }
};

}  // namespace stepwire
