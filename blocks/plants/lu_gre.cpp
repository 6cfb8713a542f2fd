#include "blocks/plants/lu_gre.hpp"

#include "engine/model/block/declare.hpp"

namespace stepwire {

void LuGre::declare(Declare<LuGre>& is) {
  is.block(
      "LuGre",
      {.doc = "Friction as bristles that bend, the LuGre model: dz/dt = v - stiffness |v| z / g(v), g(v) = "
              "coulomb + "
              "(breakaway - coulomb) exp(-(v/stribeck)^2); y = -(stiffness z + damping dz/dt + viscous v) is "
              "the force on "
              "the body. A body at rest creeps by the bend of the bristles and then holds. The numbers left "
              "out are those "
              "of the paper, whose body has 1 kg; steps of a tenth of sqrt(mass / stiffness) and less "
              "resolve the bristles. "
              "Friction sticks without them.",
       .source =
           "C. Canudas de Wit, H. Olsson, K. J. Astrom, P. Lischinsky 1995, IEEE Trans. Autom. Control 40(3)",
       .symbol = {.curve = "M-1 .5H-.1C0 1 0 -1 .1 -.5H1"},
       .smooth = true});
  is.parameter<&LuGre::stiffness>({.unit = "N/m", .doc = "of the bristles, sigma_0", .above = 0.0});
  is.parameter<&LuGre::damping>({.unit = "N s/m", .doc = "of the bristles, sigma_1", .at_least = 0.0});
  is.parameter<&LuGre::viscous>(
      {.unit = "N s/m", .doc = "friction that grows with the speed, sigma_2", .at_least = 0.0});
  is.parameter<&LuGre::coulomb>({.unit = "N", .doc = "friction of a fast motion", .above = 0.0});
  is.parameter<&LuGre::breakaway>(
      {.unit = "N", .doc = "friction of a very slow motion; `coulomb` where that is more", .at_least = 0.0});
  is.parameter<&LuGre::stribeck>(
      {.unit = "m/s", .doc = "speed at which all but 1/e of the difference is gone", .above = 0.0});
  is.input<&LuGre::velocity>({.unit = "m/s", .doc = "of the body"});
  is.output<&LuGre::y>({.unit = "N", .doc = "force of the friction on the body"});
  is.state<&LuGre::z>({.unit = "m", .doc = "mean deflection of the bristles"});
}

}  // namespace stepwire
