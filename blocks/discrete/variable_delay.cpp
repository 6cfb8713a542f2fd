#include "blocks/discrete/variable_delay.hpp"

#include "engine/model/block/declare_reset.hpp"

#include "blocks/discrete/whole_periods.hpp"

namespace stepwire {

void VariableDelay::declare(Declare<VariableDelay>& is) {
  is.block(
      "VariableDelay",
      {.doc = "Delay by a time that another signal tells, or that differs from run to run: y(t) = "
              "u(t - delay), and `initial` until then. Between samples it is linear. A delay of less than a "
              "period is one period, and one above `longest` is that. Its output does not depend on its "
              "input at the same instant.",
       .timing = Timing::discrete,
       .symbol = {.curve = "M-1 -.7H-.5C-.35 -.7 -.35 .7 -.2 .7H.4M-.4 -.7H.1C.25 -.7 .25 .7 .4 .7H1"}});
  is.parameter<&VariableDelay::longest>(
      {.unit = "s", .doc = "highest delay, whole periods: as much is kept", .above = 0.0, .required = true});
  is.parameter<&VariableDelay::initial>({.unit = "'u", .doc = "output before the first sample arrives"});
  is.input<&VariableDelay::u>({.unit = "'u", .doc = "signal to delay", .feedthrough = false});
  is.input<&VariableDelay::delay>({.unit = "s", .doc = "by how much"});
  is.output<&VariableDelay::y>({.unit = "'u", .doc = "the input, `delay` ago"});
  is.state<&VariableDelay::samples>(
      {.unit = "'u", .shape = "k x n", .doc = "samples on their way", .settable = false});
  is.state<&VariableDelay::newest>({.doc = "where the newest sample stands", .settable = false});
  declare_reset(is, "'u", "all samples on their way");
  is.clock<&VariableDelay::period>();
  is.derived<&VariableDelay::rows, &VariableDelay::longest>();
}

void VariableDelay::configure(Configure& is) {
  configure_reset(*this, is);
  rows = whole_periods<&VariableDelay::longest>(is, longest) + 1;
  is.size("k", rows);
}

}  // namespace stepwire
