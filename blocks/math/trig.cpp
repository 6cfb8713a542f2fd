#include "blocks/math/trig.hpp"

#include "engine/model/block/declare.hpp"

namespace stepwire {

void Trig::declare(Declare<Trig>& is) {
  is.block(
      "Trig",
      {.doc = "A trigonometric or hyperbolic function of each element, angles in radians. asin and acos of "
              "what lies beyond -1 to 1 is no number, which ends the run. For the angle of a direction see "
              "Atan2.",
       .symbol = {.text = "{function}"},
       .smooth = true});
  is.parameter<&Trig::function>(
      {.doc = "which", .words = {"sin", "cos", "tan", "asin", "acos", "atan", "sinh", "cosh", "tanh"}});
  is.input<&Trig::u>({.doc = "angle [rad], or for the inverses the ratio"});
  is.output<&Trig::y>({.doc = "the ratio, or for the inverses the angle [rad]"});
}

}  // namespace stepwire
