#include "blocks/continuous/derivative.hpp"

#include "engine/model/block/declare_reset.hpp"

namespace stepwire {

void Derivative::configure(Configure& is) {
  const bool given = is.initial_given<&Derivative::x>() || is.connected<&Derivative::initial_>();
  follows = settled && !given;
  const bool resets_states = configure_reset(*this, is);
  is.skip_before_instant(trigger != Trigger::level || !is.connected<&Derivative::reset>());
  if (resets_states) return;
  is.skip_instants(!follows);
  if (follows)
    is.update_keeps_outputs();
  else
    is.skip_update();
}

void Derivative::declare(Declare<Derivative>& is) {
  is.block(
      "Derivative",
      {.doc =
           "Filtered derivative, s / (tau s + 1): tau dx/dt = u - x, y = (u - x) / tau. Gain and phase are "
           "those of a derivative up to about 1 / (2 pi tau) Hz. At the first instant, and at a reset, the "
           "filter begins at the input, so that y is 0 there whatever the input is; a jump that comes later "
           "gives its peak. Where `initial` is given (a reset: `value`), the filter begins at that. An "
           "explicit solver needs a step below 2 tau (euler) or 2.7 tau (rk4).",
       .discrete = "DiscretePID with kp: 0 and kd: 1, or SavitzkyGolay",
       .symbol = {.text = "s / {tau} s + 1"},
       .smooth = true});
  is.parameter<&Derivative::tau>({.unit = "s", .doc = "time constant of the filter", .above = 0.0});
  is.parameter<&Derivative::settled>(
      {.doc = "begin as if the input had always had its first value; false: the filter begins at `initial`, "
              "0 where left out, and an input that begins elsewhere gives a peak"});
  is.input<&Derivative::u>({.unit = "'u", .doc = "signal to differentiate"});
  is.output<&Derivative::y>({.unit = "'u/s", .doc = "its derivative"});
  is.state<&Derivative::x>({.unit = "'u", .doc = "the input, filtered"});
  is.state<&Derivative::begun>(
      {.doc = "0 before the first step, then 1", .settable = false, .marks_start = true});
  is.derived<&Derivative::follows, &Derivative::settled>();
  declare_reset(is, "'u", "the filter");
}

}  // namespace stepwire
