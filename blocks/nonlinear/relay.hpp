#pragma once

#include "engine/model/block/block.hpp"

namespace stepwire {

/// Switch between two values with hysteresis: on at an upper and off at a lower threshold.
struct Relay {
  PerElement switch_on = 0.0, switch_off = 0.0, when_on = 1.0, when_off = 0.0;
  Input<> u{};
  Output<> y{};
  DiscreteState<> on{};

  void outputs() {
    y.each([&](Index i) { return is_on(i) ? when_on[i] : when_off[i]; });
  }

  void update() {
    for (Index i = 0; i < on.size(); ++i) on[i] = is_on(i) ? 1.0 : 0.0;
  }

  void crossings(Crossings& zero) const {
    for (Index i = 0; i < u.size(); ++i) zero.add(u[i] - (on[i] > 0.0 ? switch_off[i] : switch_on[i]));
  }

  void configure(Configure& is);
  static void declare(Declare<Relay>& is);

 private:
  bool is_on(Index i) const {
    if (u[i] >= switch_on[i]) return true;
    return u[i] > switch_off[i] && on[i] > 0.0;
  }
};

}  // namespace stepwire
