#include "blocks/logic/hysteresis.hpp"

#include "engine/model/block/declare.hpp"
#include "engine/model/block/limits.hpp"

namespace stepwire {

void Hysteresis::configure(Configure& is) {
  require_order<&Hysteresis::lower, &Hysteresis::upper>(*this, is);
}

void Hysteresis::declare(Declare<Hysteresis>& is) {
  is.block(
      "Hysteresis",
      {.doc =
           "1 where u >= upper, 0 where u <= lower, as it was in between; at u = lower = upper it is 1. The "
           "output "
           "shows the change at the same tick and is held between ticks. `initial` is what it was before the "
           "first tick.",
       .symbol = {.curve = "M-1 -.7H.4V.7M1 .7H-.4V-.7", .axes = true},
       .steady = true});
  is.parameter<&Hysteresis::lower>(
      {.unit = "'u", .doc = "where it becomes 0; not above upper", .required = true});
  is.parameter<&Hysteresis::upper>({.unit = "'u", .doc = "where it becomes 1", .required = true});
  is.input<&Hysteresis::u>({.unit = "'u", .doc = "signal"});
  is.crossing<&Hysteresis::u>("u reaches the threshold that switches it");
  is.output<&Hysteresis::y>({.doc = "1 or 0"});
  is.state<&Hysteresis::last>({.doc = "output at the last tick"});
}

}  // namespace stepwire
