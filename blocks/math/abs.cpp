#include "blocks/math/abs.hpp"

#include "engine/model/block/declare.hpp"

namespace stepwire {

void Abs::declare(Declare<Abs>& is) {
  is.block("Abs", {.doc = "The size of each element: y = |u|. For the length of a vector see Norm.",
                   .symbol = {.text = "|u|"},
                   .smooth = true});
  is.input<&Abs::u>({.unit = "'u", .doc = "signal"});
  is.crossing<&Abs::u>("u passes 0");
  is.output<&Abs::y>({.unit = "'u", .doc = "its size"});
}

}  // namespace stepwire
