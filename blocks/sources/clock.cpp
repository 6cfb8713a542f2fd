#include "blocks/sources/clock.hpp"

#include "blocks/sources/own_time_declare.hpp"

namespace stepwire {

void Clock::configure(Configure& is) {
  configure_own_time(*this, is);
}

void Clock::declare(Declare<Clock>& is) {
  is.block("Clock", {.doc = "The time of the run: y = t, 0 at its beginning.",
                     .symbol = {.text = "t"},
                     .at_events = true,
                     .smooth = true});
  is.output<&Clock::y>({.unit = "s", .doc = "time"});
  declare_own_time(is);
}

}  // namespace stepwire
