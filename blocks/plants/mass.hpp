#pragma once

#include "engine/model/block/resettable.hpp"

namespace stepwire {

/// Point mass: m dv/dt = F, dx/dt = v. With a vector of forces, one motion per element. A reset sets the
/// velocity.
struct Mass : ResetInput {
  PerElement mass = 1.0;
  Input<> force{}, value{};
  Output<> position{}, velocity{};
  State<> position_{}, velocity_{};
  DiscreteState<> home{};  // initial velocity

  void derivatives() {
    if (resets && held()) {
      position_.derivative = 0.0;
      velocity_.derivative = 0.0;
      return;
    }
    position_.derivative = velocity_;
    velocity_.derivative.each([&](Index i) { return force[i] / mass[i]; });
  }

  /// Runs only if something resets.
  void update() {
    if (resetting())
      for (Index i = 0; i < velocity_.size(); ++i) velocity_[i] = value.connected() ? value[i] : home[i];
    remember_reset();
  }

  void configure(Configure& is);
  void start() { home = velocity_; }
  static void declare(Declare<Mass>& is);
};

}  // namespace stepwire
