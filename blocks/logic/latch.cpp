#include "blocks/logic/latch.hpp"

#include "engine/model/block/declare.hpp"

namespace stepwire {

void Latch::declare(Declare<Latch>& is) {
  is.block(
      "Latch",
      {.doc = "Flip-flop: 1 from the tick at which `set` is true until the one at which `reset` is. True is "
              "above 0. The output shows the change at the same tick. `initial` is what it was before the "
              "first tick.",
       .at_events = true});
  is.parameter<&Latch::priority>({.doc = "which one counts while both are true", .words = {"reset", "set"}});
  is.input<&Latch::set>({.unit = "*", .doc = "makes it 1"});
  is.input<&Latch::reset>({.unit = "*", .doc = "makes it 0"});
  is.crossing<&Latch::set>("set becomes true or false");
  is.crossing<&Latch::reset>("reset becomes true or false");
  is.output<&Latch::y>({.doc = "1 or 0"});
  is.state<&Latch::last>({.doc = "output at the last tick"});
}

}  // namespace stepwire
