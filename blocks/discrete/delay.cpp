#include "blocks/discrete/delay.hpp"

#include "engine/model/block/declare_reset.hpp"

#include "blocks/discrete/whole_periods.hpp"

namespace stepwire {

void Delay::declare(Declare<Delay>& is) {
  is.block(
      "Delay",
      {.doc = "Delay by a time: y(t) = u(t - delay), and `initial` until then. The delay is a whole number "
              "of the block's periods. Its output does not depend on its input at the same instant.",
       .symbol = {.curve = "M-1 -.7H-.5C-.35 -.7 -.35 .7 -.2 .7H.4M-.4 -.7H.1C.25 -.7 .25 .7 .4 .7H1"}});
  is.parameter<&Delay::delay>(
      {.unit = "s", .doc = "by how much, whole periods", .above = 0.0, .required = true});
  is.parameter<&Delay::initial>({.unit = "'u", .doc = "output before the first sample arrives"});
  is.input<&Delay::u>({.unit = "'u", .doc = "signal to delay", .feedthrough = false});
  is.output<&Delay::y>({.unit = "'u", .doc = "the input, `delay` ago"});
  is.state<&Delay::samples>(
      {.unit = "'u", .shape = "k x n", .doc = "samples on their way", .settable = false});
  is.state<&Delay::oldest>({.doc = "where the oldest sample stands", .settable = false});
  declare_reset(is, "'u", "all samples on their way");
  is.derived<&Delay::periods, &Delay::delay>();
}

void Delay::configure(Configure& is) {
  configure_reset(*this, is);
  periods = whole_periods<&Delay::delay>(is, delay);
  is.size("k", periods);
}

}  // namespace stepwire
