#include "blocks/nonlinear/backlash.hpp"

#include "engine/model/block/declare_reset.hpp"

namespace stepwire {

void Backlash::declare(Declare<Backlash>& is) {
  is.block(
      "Backlash",
      {.doc = "Play of a gear: y[k] is y[k-1], held between u[k] - width/2 and u[k] + width/2. The output "
              "shows the "
              "push at the same tick and is held between ticks. Before the first tick it is at `initial`.",
       .source = "play operator, e.g. Visintin, Differential Models of Hysteresis, 1994, chapter III",
       .symbol = {.curve = "M-1 -.8H-.1L.9 .8M1 .8H.1L-.9 -.8", .axes = true}});
  is.parameter<&Backlash::width>({.unit = "delta 'u", .doc = "the whole gap", .at_least = 0.0});
  is.input<&Backlash::u>({.unit = "'u", .doc = "position of the driving side"});
  is.crossing_of<&Backlash::reset>("the reset signal becomes true or false");
  is.crossing<&Backlash::u>("the gap closes on the upper side");
  is.crossing<&Backlash::u>("on the lower side");
  is.output<&Backlash::y>({.unit = "'u", .doc = "position of the driven side"});
  is.state<&Backlash::last>({.unit = "'u", .doc = "output at the last tick"});
  declare_reset(is, "'u", "the driven side");
}

void Backlash::configure(Configure& is) {
  configure_reset(*this, is);
}

}  // namespace stepwire
