#include "blocks/sinks/terminator.hpp"

#include "engine/model/block/declare.hpp"

namespace stepwire {

void Terminator::declare(Declare<Terminator>& is) {
  is.block("Terminator",
           {.doc = "Takes a signal and does nothing with it. No output needs one; it says to a reader that "
                   "this one is left unused on purpose.",
            .symbol = {.curve = "M-1 0H.2M.2 -.8V.8"}});
  is.input<&Terminator::u>({.unit = "*", .doc = "signal", .feedthrough = false});
}

}  // namespace stepwire
