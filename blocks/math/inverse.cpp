#include "blocks/math/inverse.hpp"

#include "engine/model/block/declare.hpp"

namespace stepwire {

void Inverse::declare(Declare<Inverse>& is) {
  is.block("Inverse",
           {.doc = "The inverse of a square matrix, y = 1/u. A singular one ends the run, also one whose "
                   "pivots are nothing but rounding.",
            .source = "Gauss and Jordan, pivots from each column",
            .symbol = {.text = "1 / u"},
            .smooth = true});
  is.input<&Inverse::u>({.unit = "'u", .shape = "n x n", .doc = "square matrix"});
  is.output<&Inverse::y>({.unit = "1/'u", .shape = "n x n", .doc = "its inverse"});
  is.diagnostic<&Inverse::singular>(
      {.doc = "the matrix is singular and has no inverse; keep what makes it away from there, or leave the "
              "block out meanwhile by 'enable'",
       .ends_run = true});
  is.clock<&Inverse::t>();
  is.size<&Inverse::rows>("n");
}

}  // namespace stepwire
