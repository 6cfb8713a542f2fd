#include "blocks/sources/clock.hpp"

#include "engine/model/block/declare.hpp"

namespace stepwire {

void Clock::declare(Declare<Clock>& is) {
  is.block(
      "Clock",
      {.doc = "The time of the run: y = t, 0 at its beginning.", .symbol = {.text = "t"}, .smooth = true});
  is.output<&Clock::y>({.unit = "s", .doc = "time"});
  is.clock<&Clock::t>();
}

}  // namespace stepwire
