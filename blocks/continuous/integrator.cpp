#include "blocks/continuous/integrator.hpp"

#include "engine/model/block/declare_reset.hpp"
#include "engine/model/block/limits.hpp"

namespace stepwire {

void Integrator::declare(Declare<Integrator>& is) {
  is.block(
      "Integrator",
      {.doc =
           "Integral of the input: dx/dt = u, y = x. At a limit the integration stops until u points inward, "
           "so nothing winds up. A reset acts at a step: the output shows it at once, and the integration "
           "goes on from there; `before` is the integral as it arrives at the step, so that what it is reset "
           "to may follow from it: a ball is thrown back by {value: bounce} with bounce a Gain of -0.8 of "
           "v.before.",
       .discrete = "DiscreteIntegrator",
       .symbol = {.text = "1 / s"},
       .smooth = true});
  is.parameter<&Integrator::lower>({.unit = "'u s", .doc = "lowest value; none where left out"});
  is.parameter<&Integrator::upper>({.unit = "'u s", .doc = "highest value; none where left out"});
  is.input<&Integrator::u>({.unit = "'u", .doc = "rate of change", .feedthrough = false});
  is.output<&Integrator::y, &Integrator::x>({.unit = "'u s", .doc = "the integral, within the limits"});
  is.output<&Integrator::before, &Integrator::x>(
      {.unit = "'u s", .doc = "the integral before a reset and before the limits of this step"});
  is.state<&Integrator::x>({.unit = "'u s", .doc = "the integral"});
  is.state<&Integrator::stop>(
      {.doc = "1 at the upper and -1 at the lower limit at the last tick, 0 between", .settable = false});
  declare_reset(is, "'u s", "the integral");
  is.crossing<&Integrator::u>("the integral meets or leaves its lower limit");
  is.crossing<&Integrator::u>("it meets or leaves its upper limit");
  is.derived<&Integrator::slope_is_input, From::no_number>();
  is.derived<&Integrator::limited, From::no_number>();
}

void Integrator::configure(Configure& is) {
  require_order<&Integrator::lower, &Integrator::upper>(*this, is);
  limited = limits(lower, upper);
  configure_reset(*this, is);
  slope_is_input = !limited && !resets;
  if (!slope_is_input) return;
  is.skip_outputs();
  is.skip_update();
  is.skip_crossings();
  is.slope_is_input<&Integrator::x, &Integrator::u>();
}

}  // namespace stepwire
