#include "blocks/operators/ornstein_uhlenbeck.hpp"

#include "engine/model/block/declare.hpp"

namespace stepwire {

void OrnsteinUhlenbeck::configure(Configure& is) {
  is.size("n", deviation.size());
}

void OrnsteinUhlenbeck::declare(Declare<OrnsteinUhlenbeck>& is) {
  is.block(
      "OrnsteinUhlenbeck",
      {.doc = "Slow drift, as of the sense of where one's hand is: an Ornstein-Uhlenbeck process over the "
              "coordinate `along`, which is time (from a Clock), or a way or an angle that was travelled, "
              "so that what rests does not drift. Its elements are independent, and normal with mean 0 and "
              "the given deviation at all times, the first included; `correlation` farther on, 1/e of a "
              "deviation is left. The same seed gives the same drift.",
       .source = "Uhlenbeck and Ornstein 1930, Phys. Rev. 36; exact step: Gillespie 1996, Phys. Rev. E 54",
       .timing = Timing::discrete,
       .symbol = {.curve = "M-1 .2L-.8 .5L-.65 .3L-.5 .6L-.3 .1L-.15 .3L0 -.2L.2 -.6L.35 -.4L.55 -.7L.75 "
                           "-.2L1 -.4"}});
  is.parameter<&OrnsteinUhlenbeck::seed>({.doc = "which sequence; a whole number", .required = true});
  is.parameter<&OrnsteinUhlenbeck::deviation>(
      {.unit = "'u", .shape = "n", .doc = "standard deviation, one for each element", .at_least = 0.0});
  is.parameter<&OrnsteinUhlenbeck::correlation>(
      {.unit = "'s", .doc = "change of `along` over which the correlation falls to 1/e", .above = 0.0});
  is.input<&OrnsteinUhlenbeck::along>(
      {.unit = "'s",
       .doc = "coordinate of the process; what counts is how much it changes between ticks",
       .feedthrough = false});
  is.output<&OrnsteinUhlenbeck::y>({.unit = "'u", .shape = "n", .doc = "the drift"});
  is.state<&OrnsteinUhlenbeck::value>({.unit = "'u", .shape = "n", .doc = "its value", .settable = false});
  is.state<&OrnsteinUhlenbeck::last>(
      {.unit = "'s", .doc = "the coordinate at the last tick", .settable = false});
  is.state<&OrnsteinUhlenbeck::sample>({.doc = "number of the sample", .settable = false});
}

}  // namespace stepwire
