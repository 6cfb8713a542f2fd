#include "blocks/math/matrix_multiply.hpp"

#include "engine/model/block/declare.hpp"

namespace stepwire {

void MatrixMultiply::declare(Declare<MatrixMultiply>& is) {
  is.block("MatrixMultiply",
           {.doc = "The product of two matrices, y = a b. A vector is a matrix of one column. For a matrix "
                   "that does not change see MatrixGain.",
            .symbol = {.text = "a b"},
            .smooth = true});
  is.input<&MatrixMultiply::a>({.unit = "'a", .shape = "m x k", .doc = "left matrix"});
  is.input<&MatrixMultiply::b>({.unit = "'b", .shape = "k x n", .doc = "right matrix, or a vector"});
  is.output<&MatrixMultiply::y>({.unit = "'a 'b", .shape = "m x n", .doc = "the product"});
  is.size<&MatrixMultiply::rows>("m");
  is.size<&MatrixMultiply::inner>("k");
  is.size<&MatrixMultiply::columns>("n");
}

}  // namespace stepwire
