#include "blocks/math/initial_guess.hpp"

#include "engine/model/block/declare.hpp"

namespace stepwire {

void InitialGuess::declare(Declare<InitialGuess>& is) {
  is.block("InitialGuess",
           {.doc = "Passes its input on, y = u. An algebraic loop through it is solved for y (with "
                   "`algebraic_loops: solve`), and the first search begins at `guess`, all others at the last "
                   "solution. So a loop with several solutions gets that which is meant, and one whose blocks "
                   "have no finite value at 0 is solved at all. An equation 0 = f(y) is u: [y, f] into a Sum, "
                   "and this block behind it.",
            .source = "as IC and the initial guess of Algebraic Constraint in Simulink",
            .symbol = {.text = "{guess}?"},
            .torn = true});
  is.parameter<&InitialGuess::guess>({.unit = "'u", .doc = "where the search begins", .required = true});
  is.input<&InitialGuess::u>({.unit = "'u", .doc = "what the loop makes of y"});
  is.output<&InitialGuess::y>({.unit = "'u", .doc = "the same"});
}

}  // namespace stepwire
