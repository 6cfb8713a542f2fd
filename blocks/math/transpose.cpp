#include "blocks/math/transpose.hpp"

#include "engine/model/block/declare.hpp"

namespace stepwire {

void Transpose::declare(Declare<Transpose>& is) {
  is.block("Transpose", {.doc = "Makes rows of columns: y = u'. A vector becomes a matrix of one row.",
                         .symbol = {.text = "u'"},
                         .smooth = true});
  is.input<&Transpose::u>({.unit = "'u", .shape = "m x n", .doc = "matrix"});
  is.output<&Transpose::y>({.unit = "'u", .shape = "n x m", .doc = "its transpose"});
  is.size<&Transpose::rows>("m");
  is.size<&Transpose::columns>("n");
}

}  // namespace stepwire
