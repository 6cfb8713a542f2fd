#include "blocks/sources/pulse.hpp"

#include "engine/model/block/declare.hpp"

namespace stepwire {

void Pulse::declare(Declare<Pulse>& is) {
  is.block(
      "Pulse",
      {.doc = "A train of rectangles: from delay on, y = bias + amplitude during the first `width` of each "
              "period and y = bias otherwise.",
       .symbol = {.curve = "M-1 -.6H-.7V.6H-.2V-.6H.3V.6H.8V-.6H1"}});
  is.parameter<&Pulse::amplitude>({.unit = "'u", .doc = "height of a pulse above the bias"});
  is.parameter<&Pulse::period>({.unit = "s", .doc = "from one rising edge to the next", .above = 0.0});
  is.parameter<&Pulse::width>(
      {.doc = "share of the period that is high: 0.3 or 30 %", .at_least = 0.0, .at_most = 1.0});
  is.parameter<&Pulse::delay>({.unit = "s", .doc = "instant of the first rising edge"});
  is.parameter<&Pulse::bias>({.unit = "'u", .doc = "value between the pulses"});
  is.output<&Pulse::y>({.unit = "'u", .doc = "the pulses"});
  is.clock<&Pulse::t>();
}

}  // namespace stepwire
