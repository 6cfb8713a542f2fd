#include "blocks/math/min_max.hpp"

#include <algorithm>

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
  is.crossing<&MinMax::u>("another signal becomes the least or the greatest", "g x n");
  is.output<&MinMax::y>({.unit = "'u", .doc = "the least or the greatest"});
}

void MinMax::configure(Configure& is) {
  const Index others = is.count<&MinMax::u>() - 1;
  if (others < 1) is.skip_crossings();
  is.size("g", std::max<Index>(others, 1));
}

}  // namespace stepwire
