#include "blocks/routing/mux.hpp"

namespace stepwire {

void Mux::declare(Declare<Mux>& is) {
  is.block(
      "Mux",
      {.doc =
           "Puts numbers into one vector: y = [u1, u2, ...]. They must have one unit, as every vector has."});
  is.input<&Mux::u>({.unit = "'u", .shape = "1", .doc = "numbers, in the order of the vector"});
  is.output<&Mux::y>({.unit = "'u", .shape = "n", .doc = "the vector"});
}

}  // namespace stepwire
