#include "blocks/continuous/lag.hpp"

#include "engine/model/block/declare_reset.hpp"

namespace stepwire {

void Lag::declare(Declare<Lag>& is) {
  is.block("Lag", {.doc = "First-order lag: tau dx/dt = gain u - x, y = x.",
                   .discrete = "DiscreteTransferFunction",
                   .symbol = {.text = "{gain} / {tau} s + 1"},
                   .smooth = true});
  is.parameter<&Lag::tau>({.unit = "s", .doc = "time constant", .above = 0.0});
  is.parameter<&Lag::gain>({.unit = "'k", .doc = "static gain"});
  is.input<&Lag::u>({.unit = "'u", .doc = "signal to smooth", .feedthrough = false});
  is.output<&Lag::y, &Lag::x>({.unit = "'k 'u", .doc = "smoothed signal"});
  is.state<&Lag::x>({.unit = "'k 'u", .doc = "filter state"});
  declare_reset(is, "'k 'u");
  is.prepared<&Lag::decay>();
}

void Lag::configure(Configure& is) {
  if (configure_reset(*this, is)) return;
  is.skip_outputs();
  is.skip_update();
}

}  // namespace stepwire
