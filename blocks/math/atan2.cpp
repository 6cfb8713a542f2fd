#include "blocks/math/atan2.hpp"

#include "engine/model/block/declare.hpp"

namespace stepwire {

void Atan2::declare(Declare<Atan2>& is) {
  is.block(
      "Atan2",
      {.doc = "The angle of a direction in all four quadrants: y = atan2(opposite, adjacent), from -pi to "
              "pi; 0 where both are zero.",
       .symbol = {.text = "atan2"}});
  is.input<&Atan2::opposite>({.unit = "'u", .doc = "part across, y of the direction"});
  is.input<&Atan2::adjacent>({.unit = "'u", .doc = "part along, x of the direction"});
  is.output<&Atan2::y>({.unit = "rad", .doc = "the angle"});
}

}  // namespace stepwire
