#include "blocks/math/concatenate.hpp"

#include "engine/model/block/declare.hpp"

namespace stepwire {

void Concatenate::declare(Declare<Concatenate>& is) {
  is.block("Concatenate",
           {.doc = "Matrices and vectors side by side, y = [u1, u2, ..]; they have as many rows. One below "
                   "the other: Stack, and vectors into one: Mux.",
            .symbol = {.outline = Symbol::Outline::bar}});
  is.input<&Concatenate::u>({.unit = "'u", .shape = "m x +n", .doc = "matrices, from the left"});
  is.output<&Concatenate::y>({.unit = "'u", .shape = "m x n", .doc = "all their columns"});
}

void Stack::declare(Declare<Stack>& is) {
  is.block("Stack", {.doc = "Matrices one below the other; they have as many columns.",
                     .symbol = {.outline = Symbol::Outline::bar},
                     .header = "concatenate.hpp"});
  is.input<&Stack::u>({.unit = "'u", .shape = "+m x n", .doc = "matrices, from above"});
  is.output<&Stack::y>({.unit = "'u", .shape = "m x n", .doc = "all their rows"});
  is.size<&Stack::rows>("m");
  is.size<&Stack::columns>("n");
}

}  // namespace stepwire
