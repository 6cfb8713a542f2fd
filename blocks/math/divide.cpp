#include "blocks/math/divide.hpp"

#include "engine/model/block/declare.hpp"

namespace stepwire {

void Divide::declare(Declare<Divide>& is) {
  is.block("Divide",
           {.doc = "Divides element by element: y = numerator / denominator. A zero below gives no finite "
                   "number, which ends the run.",
            .symbol = {.text = "÷"},
            .smooth = true});
  is.input<&Divide::numerator>({.unit = "'a", .doc = "what is divided"});
  is.input<&Divide::denominator>({.unit = "'b", .doc = "by what"});
  is.output<&Divide::y>({.unit = "'a/'b", .doc = "the quotient"});
}

}  // namespace stepwire
