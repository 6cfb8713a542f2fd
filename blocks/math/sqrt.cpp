#include "blocks/math/sqrt.hpp"

#include "engine/model/block/declare.hpp"

namespace stepwire {

void Sqrt::declare(Declare<Sqrt>& is) {
  is.block(
      "Sqrt",
      {.doc = "The square root of each element: y = sqrt(u). Below zero it is no number, which ends the run, "
              "unless `signed` is true.",
       .symbol = {.text = "√u"},
       .smooth = true});
  is.parameter<&Sqrt::signed_>({.doc = "true: y = sign(u) sqrt(|u|), as in the flow through an orifice"});
  is.input<&Sqrt::u>({.unit = "'u", .doc = "signal"});
  is.output<&Sqrt::y>({.unit = "'u^0.5", .doc = "its root"});
}

}  // namespace stepwire
