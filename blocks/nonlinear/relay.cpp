#include "blocks/nonlinear/relay.hpp"

#include "engine/model/block/declare.hpp"
#include "engine/model/block/limits.hpp"

namespace stepwire {

void Relay::configure(Configure& is) {
  require_order<&Relay::switch_off, &Relay::switch_on>(*this, is);
}

void Relay::declare(Declare<Relay>& is) {
  is.block(
      "Relay",
      {.doc = "Switches between two values: on where u >= switch_on, off where u <= switch_off, and as it "
              "was in "
              "between. Where both thresholds are one number and u is there, it is on. The output shows the "
              "switching at the same tick and is held between ticks. `initial` is 1 for on, 0 for off.",
       .symbol = {.curve = "M-1 -.7H.4V.7M1 .7H-.4V-.7", .axes = true},
       .steady = true});
  is.parameter<&Relay::switch_on>({.unit = "'u", .doc = "where it switches on"});
  is.parameter<&Relay::switch_off>({.unit = "'u", .doc = "where it switches off; not above switch_on"});
  is.parameter<&Relay::when_on>({.unit = "'y", .doc = "output while on"});
  is.parameter<&Relay::when_off>({.unit = "'y", .doc = "output while off"});
  is.input<&Relay::u>({.unit = "'u", .doc = "signal"});
  is.output<&Relay::y>({.unit = "'y", .doc = "one of the two values"});
  is.crossing<&Relay::u>("u reaches the threshold that switches it");
  is.state<&Relay::on>({.doc = "1 on, 0 off"});
}

}  // namespace stepwire
