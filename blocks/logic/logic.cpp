#include "blocks/logic/logic.hpp"

#include "engine/model/block/declare.hpp"

namespace stepwire {

void Logic::declare(Declare<Logic>& is) {
  is.block("Logic",
           {.doc = "Joins truths to 1 or 0. An input is true where it is above 0. `xor` is true where an odd "
                   "number of inputs is true, `xnor` where an even number is; `not` takes one input.",
            .symbol = {.text = "{operator}"}});
  is.parameter<&Logic::operator_>({.doc = "how the inputs are joined",
                                   .words = {"and", "or", "not", "nand", "nor", "xor", "xnor"},
                                   .required = true});
  is.input<&Logic::u>({.unit = "*", .doc = "truths"});
  is.crossing<&Logic::u>("an input becomes true or false", "c x n");
  is.output<&Logic::y>({.doc = "1 or 0"});
}

void Logic::configure(Configure& is) {
  is.size("c", is.count<&Logic::u>());
  if (operator_ == Operator::not_ && is.count<&Logic::u>() > 1)
    is.refuse<&Logic::operator_>("'not' takes one input; for several, 'nor' or 'nand' is meant");
}

}  // namespace stepwire
