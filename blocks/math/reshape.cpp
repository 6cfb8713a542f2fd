#include "blocks/math/reshape.hpp"

#include "engine/model/block/declare.hpp"

namespace stepwire {

void Reshape::declare(Declare<Reshape>& is) {
  is.block("Reshape", {.doc = "The same numbers in another shape: a vector as a matrix, or a matrix as "
                              "another one. Numbers of a matrix are counted column by column.",
                       .symbol = {.text = "{rows} x {columns}"},
                       .smooth = true});
  is.parameter<&Reshape::rows>(
      {.doc = "rows of the result", .at_least = 1, .at_most = 1000, .required = true, .structural = true});
  is.parameter<&Reshape::columns>(
      {.doc = "columns of the result; 1 of a vector", .at_least = 1, .at_most = 1000, .structural = true});
  is.input<&Reshape::u>({.unit = "'u", .shape = "k", .doc = "vector or matrix"});
  is.output<&Reshape::y>({.unit = "'u", .shape = "m x n", .doc = "the same numbers"});
}

}  // namespace stepwire
