#include "blocks/plants/hard_stop.hpp"

#include "engine/model/block/declare.hpp"
#include "engine/model/block/limits.hpp"

namespace stepwire {

void HardStop::declare(Declare<HardStop>& is) {
  is.block("HardStop",
           {.doc = "Rigid stops at `lower` and `upper` for a mass. Where it runs into one, `hit` is 1 at "
                   "that instant and `rebound` "
                   "is the velocity behind it, which belong to `reset` and `value` of what integrates the "
                   "velocity (Mass, "
                   "Integrator). Where it would be thrown back more slowly than `slow`, that velocity is 0 "
                   "and it rests there: `y` "
                   "balances the other forces until they pull it away. It is decided at ticks, and at the "
                   "instants themselves with `events: locate`. Wire the sum of all other forces to `force`, "
                   "that sum and `y` to the mass, and states of the mass to position and velocity (of an "
                   "Integrator with a reset "
                   "its `before`).",
            .source = "Newton's law of impact",
            .timing = Timing::continuous,
            .symbol = {.curve = "M-.8 -.8V.8M.8 -.8V.8M-.5 0H.5M.3 -.2L.5 0L.3 .2"},
            .at_end = true});
  is.parameter<&HardStop::mass>(
      {.unit = "kg", .doc = "of the body, as in Mass", .above = 0.0, .required = true});
  is.parameter<&HardStop::lower>({.unit = "m", .doc = "position of the lower stop; none where left out"});
  is.parameter<&HardStop::upper>({.unit = "m", .doc = "position of the upper stop; none where left out"});
  is.parameter<&HardStop::restitution>(
      {.doc = "speed behind an impact over that before it", .at_least = 0.0, .at_most = 1.0});
  is.parameter<&HardStop::slow>(
      {.unit = "m/s", .doc = "speed behind an impact below which the body rests", .at_least = 0.0});
  is.input<&HardStop::force>({.unit = "N", .doc = "sum of all other forces on the body"});
  is.input<&HardStop::position>({.unit = "m", .doc = "of the body"});
  is.input<&HardStop::velocity>({.unit = "m/s", .doc = "of the body"});
  is.crossing<&HardStop::force, &HardStop::position>("the body meets the upper stop, or is pulled from one");
  is.crossing<&HardStop::position>("the body meets the lower stop");
  is.output<&HardStop::y>({.unit = "N", .doc = "force of the stop on a body that rests there"});
  is.output<&HardStop::hit>({.doc = "1 at the instant of an impact"});
  is.output<&HardStop::rebound>({.unit = "m/s", .doc = "velocity behind that impact"});
  is.output<&HardStop::rests>({.doc = "1 and -1 while it rests at the upper and the lower stop, else 0"});
  is.state<&HardStop::side>({.doc = "the same, as it was at the last instant", .settable = false});
  is.state<&HardStop::rest>({.unit = "m/s", .doc = "velocity at the last instant", .settable = false});
  is.state<&HardStop::struck>(
      {.doc = "1 where the last instant was that of an impact, -1 where not, 0 before the first",
       .settable = false});
  is.state<&HardStop::struck_at>(
      {.unit = "s", .doc = "time of the last hit at a tick; -1 before the first one", .settable = false});
  is.diagnostic<&HardStop::begins_beyond>(
      {.doc = "the body begins beyond a stop; give it an initial position between `lower` and `upper`",
       .ends_run = true});
  is.clock<&HardStop::t>();
  is.clock<&HardStop::period>();
}

void HardStop::configure(Configure& is) {
  require_order<&HardStop::lower, &HardStop::upper>(*this, is);
}

}  // namespace stepwire
