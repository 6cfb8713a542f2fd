#include "blocks/sources/pulse.hpp"

#include "blocks/sources/own_time_declare.hpp"

namespace stepwire {

void Pulse::configure(Configure& is) {
  configure_own_time(*this, is);
}

void Pulse::declare(Declare<Pulse>& is) {
  is.block(
      "Pulse",
      {.doc = "A train of rectangles: from delay on, y = bias + amplitude during the first `width` of each "
              "period and y = bias otherwise. With `phase` the train begins within a period.",
       .symbol = {.curve = "M-1 -.6H-.7V.6H-.2V-.6H.3V.6H.8V-.6H1"},
       .at_events = true});
  is.parameter<&Pulse::amplitude>({.unit = "delta 'u", .doc = "height of a pulse above the bias"});
  is.parameter<&Pulse::period>({.unit = "s", .doc = "from one rising edge to the next", .above = 0.0});
  is.parameter<&Pulse::width>(
      {.doc = "share of the period that is high: 0.3 or 30 %", .at_least = 0.0, .at_most = 1.0});
  is.parameter<&Pulse::delay>({.unit = "s", .doc = "instant at which the train begins"});
  is.parameter<&Pulse::phase>(
      {.unit = "rad",
       .doc = "where in its period the train begins: 0 at a rising edge, 90 deg a quarter behind it"});
  is.parameter<&Pulse::bias>({.unit = "'u", .doc = "value between the pulses"});
  is.output<&Pulse::y>({.unit = "'u", .doc = "the pulses"});
  declare_own_time(is);
}

}  // namespace stepwire
