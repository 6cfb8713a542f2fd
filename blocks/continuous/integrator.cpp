#include "blocks/continuous/integrator.hpp"

#include "engine/model/block/declare.hpp"
#include "engine/model/block/limits.hpp"

namespace stepwire {

void Integrator::declare(Declare<Integrator>& is) {
  is.block(
      "Integrator",
      {.doc =
           "Integral of the input: dx/dt = u, y = x. At a limit the integration stops until u points inward, "
           "so nothing winds up. A reset acts at a step: the output shows it at once, and the integration "
           "goes on from there.",
       .symbol = {.text = "1 / s"}});
  is.parameter<&Integrator::lower>({.unit = "'u s", .doc = "lowest value; none where left out"});
  is.parameter<&Integrator::upper>({.unit = "'u s", .doc = "highest value; none where left out"});
  is.parameter<&Integrator::trigger>(
      {.doc = "what of the reset signal resets: it becomes true (rising), false (falling), either, or it is "
              "true "
              "(level: held until it is false again). True is above 0; there is no edge at the first step",
       .words = {"rising", "falling", "either", "level"}});
  is.input<&Integrator::u>({.unit = "'u", .doc = "rate of change", .feedthrough = false});
  is.input<&Integrator::reset>({.unit = "*", .doc = "resets all elements", .optional = true});
  is.input<&Integrator::value>({.unit = "'u s",
                                .doc = "what a reset goes to; the initial value where nothing is wired",
                                .optional = true});
  is.output<&Integrator::y, &Integrator::x>({.unit = "'u s", .doc = "the integral, within the limits"});
  is.state<&Integrator::x>({.unit = "'u s", .doc = "the integral"});
  is.state<&Integrator::home>({.unit = "'u s", .doc = "initial value", .settable = false});
  is.state<&Integrator::stop>(
      {.doc = "1 at the upper and -1 at the lower limit at the last tick, 0 between", .settable = false});
  is.state<&Integrator::side>({.doc = "last reset signal: -1 false, 1 true, 0 none yet", .settable = false});
  is.derived<&Integrator::slope_is_input, From::no_number>();
  is.derived<&Integrator::limited, From::no_number>();
  is.derived<&Integrator::resets, From::no_number>();
}

void Integrator::configure(Configure& is) {
  require_order<&Integrator::lower, &Integrator::upper>(*this, is);
  limited = limits(lower, upper);
  resets = is.connected<&Integrator::reset>();
  if (!resets && is.connected<&Integrator::value>())
    is.require<&Integrator::reset>("a value to reset to is wired");
  slope_is_input = !limited && !resets;
  if (!slope_is_input) return;
  is.skip_outputs();
  is.skip_update();
  is.slope_is_input<&Integrator::x, &Integrator::u>();
}

}  // namespace stepwire
