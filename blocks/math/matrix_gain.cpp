#include "blocks/math/matrix_gain.hpp"

#include "engine/model/block/declare.hpp"

namespace stepwire {

void MatrixGain::declare(Declare<MatrixGain>& is) {
  is.block("MatrixGain",
           {.doc = "A matrix times a vector: y = gain u. It has a column for each element of u and a row "
                   "for each of y; [[1, 1, 1]] adds the elements of a vector.",
            .symbol = {.text = "{gain|K}", .outline = Symbol::Outline::triangle},
            .smooth = true});
  is.parameter<&MatrixGain::gain>(
      {.unit = "'k", .shape = "m x n", .doc = "the matrix as a list of rows", .required = true});
  is.input<&MatrixGain::u>({.unit = "'u", .shape = "n", .doc = "vector"});
  is.output<&MatrixGain::y>({.unit = "'k 'u", .shape = "m", .doc = "the matrix times u"});
}

}  // namespace stepwire
