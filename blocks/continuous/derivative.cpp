#include "blocks/continuous/derivative.hpp"

#include "engine/model/block/declare_reset.hpp"

namespace stepwire {

void Derivative::configure(Configure& is) {
  if (!configure_reset(*this, is) && !settled) is.skip_update();
}

void Derivative::declare(Declare<Derivative>& is) {
  is.block(
      "Derivative",
      {.doc =
           "Filtered derivative, s / (tau s + 1): tau dx/dt = u - x, y = (u - x) / tau. Gain and phase are "
           "those of a derivative up to about 1 / (2 pi tau) Hz. An explicit solver needs a step below 2 tau "
           "(euler) or 2.7 tau (rk4).",
       .symbol = {.text = "s / {tau} s + 1"},
       .smooth = true});
  is.parameter<&Derivative::tau>({.unit = "s", .doc = "time constant of the filter", .above = 0.0});
  is.parameter<&Derivative::settled>(
      {.doc = "start as if the input had always had its first value, so that y starts at 0; otherwise the "
              "filter "
              "starts at `initial`, and an input that starts elsewhere gives a peak"});
  is.input<&Derivative::u>({.unit = "'u", .doc = "signal to differentiate"});
  is.output<&Derivative::y>({.unit = "'u/s", .doc = "its derivative"});
  is.state<&Derivative::x>({.unit = "'u", .doc = "the input, filtered"});
  is.state<&Derivative::begun>({.doc = "0 before the first step, then 1", .settable = false});
  declare_reset(is, "'u", "the filter");
}

}  // namespace stepwire
