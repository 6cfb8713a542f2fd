#include "blocks/plants/mass.hpp"

#include "engine/model/block/declare_reset.hpp"

namespace stepwire {

void Mass::declare(Declare<Mass>& is) {
  is.block("Mass",
           {.doc = "A point mass on a line, or along several axes: m dv/dt = F, dx/dt = v. A reset sets the "
                   "velocity, as an impact does; the outputs show it behind that instant."});
  is.parameter<&Mass::mass>({.unit = "kg", .doc = "moving mass", .above = 0.0});
  is.input<&Mass::force>({.unit = "N", .doc = "sum of the forces on the mass", .feedthrough = false});
  is.output<&Mass::position, &Mass::position_>({.unit = "m", .doc = "position"});
  is.output<&Mass::velocity, &Mass::velocity_>({.unit = "m/s", .doc = "velocity"});
  is.state<&Mass::position_>({.unit = "m", .doc = "position"});
  is.state<&Mass::velocity_>({.unit = "m/s", .doc = "velocity"});
  is.parameter<&Mass::trigger>(
      {.doc = "what of the reset signal resets: it becomes true (rising), false (falling), either, or it is "
              "true (level: "
              "held until it is false again). True is above 0; there is no edge at the first step",
       .words = {"rising", "falling", "either", "level"}});
  is.input<&Mass::reset>({.unit = "*", .doc = "sets the velocity", .feedthrough = false, .optional = true});
  is.state<&Mass::side>({.doc = "last reset signal: -1 false, 1 true, 0 none yet", .settable = false});
  is.derived<&Mass::resets, From::no_number>();
  is.crossing_of<&Mass::reset>("the reset signal becomes true or false");
  is.input<&Mass::value>({.unit = "m/s",
                          .doc = "velocity that a reset sets; the initial one where nothing is wired",
                          .feedthrough = false,
                          .optional = true});
  is.state<&Mass::home>({.unit = "m/s", .doc = "initial velocity", .settable = false});
}

void Mass::configure(Configure& is) {
  if (!is.connected<&Mass::reset>() && is.connected<&Mass::value>())
    is.require<&Mass::reset>("a velocity to reset to is wired");
  if (trigger == Trigger::level && is.connected<&Mass::value>() && !is.constant<&Mass::value>())
    throw ParameterRefused(
        "trigger",
        "a level trigger holds the mass, so its velocity cannot follow a signal: use rising, "
        "falling or either, or leave `value` out");
  if (!configure_reset_input(*this, is)) is.skip_update();
}

}  // namespace stepwire
