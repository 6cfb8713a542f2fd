#include "blocks/math/concatenate.hpp"

#include "engine/model/block/declare.hpp"

namespace stepwire {

void Concatenate::declare(Declare<Concatenate>& is) {
  is.block("Concatenate",
           {.doc = "Matrices and vectors side by side, y = [u1, u2, ..]; they have as many rows. One below "
                   "the other: Stack, and vectors into one: Mux.",
            .symbol = {.outline = Symbol::Outline::bar},
            .smooth = true});
  is.input<&Concatenate::u>({.unit = "'u", .shape = "m x +n", .doc = "matrices, from the left"});
  is.output<&Concatenate::y>({.unit = "'u", .shape = "m x n", .doc = "all their columns"});
}

}  // namespace stepwire
