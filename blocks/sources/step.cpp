#include "blocks/sources/step.hpp"

#include "engine/model/block/declare.hpp"

namespace stepwire {

void Step::declare(Declare<Step>& is) {
  is.block(
      "Step",
      {.doc = "A jump at one instant: y = before for t < time, y = after from then on. Instants that lie "
              "on a tick are hit at that tick; the solver's last stage before it sees the new value.",
       .symbol = {.curve = "M-1 -.7H0V.7H1"}});
  is.parameter<&Step::time>({.unit = "s", .doc = "instant of the jump"});
  is.parameter<&Step::before>({.unit = "'u", .doc = "value before the jump"});
  is.parameter<&Step::after>({.unit = "'u", .doc = "value from the jump on"});
  is.output<&Step::y>({.unit = "'u", .doc = "the step"});
  is.clock<&Step::t>();
}

}  // namespace stepwire
