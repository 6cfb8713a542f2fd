#include "blocks/routing/mux.hpp"

#include "engine/model/block/declare.hpp"

namespace stepwire {

void Mux::declare(Declare<Mux>& is) {
  is.block(
      "Mux",
      {.doc =
           "Puts numbers and vectors into one vector, one behind the other: y = [u1, u2, ...]. They may "
           "have different units, as a Kalman filter of [m, rad] needs; a block that takes one unit refuses "
           "such a vector.",
       .symbol = {.outline = Symbol::Outline::bar},
       .smooth = true});
  is.input<&Mux::u>({.unit = "'u", .shape = "+n", .doc = "pieces, in the order of the vector"});
  is.output<&Mux::y>({.unit = "'u", .shape = "n", .doc = "the vector"});
}

}  // namespace stepwire
