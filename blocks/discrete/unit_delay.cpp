#include "blocks/discrete/unit_delay.hpp"

#include "engine/model/block/declare_reset.hpp"

namespace stepwire {

void UnitDelay::declare(Declare<UnitDelay>& is) {
  is.block("UnitDelay",
           {.doc = "Delay by one period: y[k] = u[k-1], y[0] = initial. Its output does not depend on its "
                   "input at the same instant, so it also cuts an algebraic loop, at the price of that "
                   "period.",
            .symbol = {.text = "1 / z"}});
  is.input<&UnitDelay::u>({.unit = "'u", .doc = "signal to delay", .feedthrough = false});
  is.output<&UnitDelay::y>({.unit = "'u", .doc = "the input one period ago"});
  is.state<&UnitDelay::x>({.unit = "'u", .doc = "the last input"});
  declare_reset(is, "'u", "the output");
}

void UnitDelay::configure(Configure& is) {
  configure_reset(*this, is);
}

}  // namespace stepwire
