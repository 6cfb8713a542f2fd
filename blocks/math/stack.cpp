#include "blocks/math/stack.hpp"

#include "engine/model/block/declare.hpp"

namespace stepwire {

void Stack::declare(Declare<Stack>& is) {
  is.block("Stack", {.doc = "Matrices one below the other; they have as many columns.",
                     .symbol = {.outline = Symbol::Outline::bar},
                     .smooth = true});
  is.input<&Stack::u>({.unit = "'u", .shape = "+m x n", .doc = "matrices, from above"});
  is.output<&Stack::y>({.unit = "'u", .shape = "m x n", .doc = "all their rows"});
  is.size<&Stack::rows>("m");
  is.size<&Stack::columns>("n");
}

}  // namespace stepwire
