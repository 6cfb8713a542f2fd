#include "blocks/discrete/zero_order_hold.hpp"

#include "engine/model/block/declare.hpp"

namespace stepwire {

void ZeroOrderHold::declare(Declare<ZeroOrderHold>& is) {
  is.block(
      "ZeroOrderHold",
      {.doc = "Samples its input at its own ticks (`every`) and holds it until the next: y(t) = u(k T) for "
              "k T <= t < (k+1) T. Without `every` it holds from step to step.",
       .timing = Timing::discrete,
       .symbol = {.curve = "M-1 -.8H-.5V-.2H0V.3H.5V.8H1"}});
  is.input<&ZeroOrderHold::u>({.unit = "'u", .doc = "signal to sample"});
  is.output<&ZeroOrderHold::y>({.unit = "'u", .doc = "the last sample"});
}

}  // namespace stepwire
