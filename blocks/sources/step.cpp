#include "blocks/sources/step.hpp"

#include "blocks/sources/own_time_declare.hpp"

namespace stepwire {

void Step::configure(Configure& is) {
  configure_own_time(*this, is);
}

void Step::declare(Declare<Step>& is) {
  is.block(
      "Step",
      {.doc = "A jump at one instant: y = before for t < time, y = after from then on. Instants that lie "
              "on a tick are hit at that tick; the step of the solver before it does not see the new value.",
       .symbol = {.curve = "M-1 -.7H0V.7H1"},
       .at_events = true});
  is.parameter<&Step::time>({.unit = "s", .doc = "instant of the jump"});
  is.parameter<&Step::before>({.unit = "'u", .doc = "value before the jump"});
  is.parameter<&Step::after>({.unit = "'u", .doc = "value from the jump on"});
  is.output<&Step::y>({.unit = "'u", .doc = "the step"});
  declare_own_time(is);
}

}  // namespace stepwire
