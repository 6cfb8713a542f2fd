#include "blocks/logic/edge_detect.hpp"

#include "engine/model/block/declare.hpp"

namespace stepwire {

void EdgeDetect::declare(Declare<EdgeDetect>& is) {
  is.block(
      "EdgeDetect",
      {.doc = "1 at the one tick at which the input becomes true (rising), false (falling), or either; 0 "
              "at all others. True is above 0. There is no edge at the first tick. With `events: locate` an "
              "edge "
              "between two ticks is 1 from its own instant through the next tick, up to the tick after that.",
       .symbol = {.curve = "M-1 -.7H0V.7H1M-.3 -.1L0 .3L.3 -.1"},
       .steady = true});
  is.parameter<&EdgeDetect::edge>({.doc = "which edges", .words = {"rising", "falling", "either"}});
  is.input<&EdgeDetect::u>({.unit = "*", .doc = "signal"});
  is.crossing<&EdgeDetect::u>("u becomes true or false");
  is.output<&EdgeDetect::y>({.doc = "1 or 0"});
  is.state<&EdgeDetect::side>(
      {.doc = "input at the last tick: -1 false, 1 true, 0 none yet", .settable = false});
  is.state<&EdgeDetect::found>({.doc = "1 after an edge that no tick has shown yet", .settable = false});
}

}  // namespace stepwire
