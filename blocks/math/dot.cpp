#include "blocks/math/dot.hpp"

#include "engine/model/block/declare.hpp"

#include "blocks/math/two_inputs.hpp"

namespace stepwire {

void Dot::configure(Configure& is) {
  require_two<&Dot::u>(is);
}

void Dot::declare(Declare<Dot>& is) {
  is.block(
      "Dot",
      {.doc = "The scalar product of two vectors: y = sum u1_k u2_k, e.g. power from force and velocity. An "
              "input of one element counts for every element of the other.",
       .symbol = {.text = "u · v"},
       .smooth = true});
  is.input<&Dot::u>({.unit = "'u", .doc = "two vectors", .multiply_units = true, .one_unit = true});
  is.output<&Dot::y>({.unit = "'u", .doc = "their product, one number"});
}

}  // namespace stepwire
