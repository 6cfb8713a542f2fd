#include "blocks/math/sign.hpp"

#include "engine/model/block/declare.hpp"

namespace stepwire {

void Sign::declare(Declare<Sign>& is) {
  is.block(
      "Sign",
      {.doc = "The sign of each element: 1 above zero, -1 below, 0 at zero. In a feedback it chatters at "
              "every step; Coulomb and Relay are meant for that.",
       .symbol = {.curve = "M-1 -.7H0V.7H1", .axes = true},
       .steady = true});
  is.input<&Sign::u>({.unit = "*", .doc = "signal"});
  is.crossing<&Sign::u>("u passes 0");
  is.output<&Sign::y>({.doc = "1, 0 or -1"});
}

}  // namespace stepwire
