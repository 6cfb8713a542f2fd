#include "blocks/math/min_max.hpp"

#include "engine/model/block/declare.hpp"

namespace stepwire {

void MinMax::declare(Declare<MinMax>& is) {
  is.block(
      "MinMax",
      {.doc = "The least or the greatest of several signals, element by element. An input of one element "
              "counts for every element of the others. The greatest |element| of one vector is a Norm.",
       .symbol = {.text = "{function}"},
       .smooth = true});
  is.parameter<&MinMax::function>({.doc = "which of both", .words = {"min", "max"}});
  is.input<&MinMax::u>({.unit = "'u", .doc = "signals, all of one unit"});
  is.output<&MinMax::y>({.unit = "'u", .doc = "the least or the greatest"});
}

}  // namespace stepwire
