#include "blocks/math/cross.hpp"

#include "engine/model/block/declare.hpp"

#include "blocks/math/two_inputs.hpp"

namespace stepwire {

void Cross::configure(Configure& is) {
  require_two<&Cross::u>(is);
}

void Cross::declare(Declare<Cross>& is) {
  is.block(
      "Cross",
      {.doc = "The vector product of two vectors in space: y = u1 x u2, e.g. torque from lever and force.",
       .symbol = {.text = "u × v"},
       .smooth = true});
  is.input<&Cross::u>(
      {.unit = "'u", .shape = "3", .doc = "two vectors of 3 elements", .multiply_units = true});
  is.output<&Cross::y>({.unit = "'u", .doc = "their product"});
}

}  // namespace stepwire
