#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

#include "blocks/sources/own_time.hpp"
#include "engine/base/math/elementary.hpp"
#include "engine/base/math/instant.hpp"

namespace stepwire {

/// Sine whose frequency changes from one value to another in a given time and then stays. Signal: y =
/// amplitude sin(2 pi cycles(t) + phase) + bias, with d cycles / dt the frequency at t.
struct Chirp : OwnTime {
  enum class Sweep { linear, exponential };

  double amplitude = 1.0, frequency = 0.1, target_frequency = 1.0, target_time = 10.0, phase = 0.0,
         bias = 0.0;
  Sweep sweep = Sweep::linear;
  Output<1> y{};

  void outputs() { y = amplitude * fn::sin(2.0 * std::numbers::pi * cycles(own()) + phase) + bias; }

  /// Returns the time from which on the frequency is constant.
  double next_edge() const { return first_ahead(t, began() + target_time); }

  /// Returns the integral of the frequency from 0 to `time`.
  double cycles(double time) const {
    const double moving = std::min(time, target_time);
    return moved(moving) + target_frequency * (time - moving);
  }

  void update() { keep_origin(); }
  void configure(Configure& is);
  static void declare(Declare<Chirp>& is);

 private:
  double moved(double time) const {
    const double ratio = target_frequency / frequency;
    if (sweep == Sweep::exponential && ratio != 1.0)
      return frequency * target_time / fn::log(ratio) * fn::expm1(fn::log(ratio) * time / target_time);
    return time * (frequency + 0.5 * (target_frequency - frequency) * time / target_time);
  }
};

}  // namespace stepwire
