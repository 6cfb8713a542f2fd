#include "blocks/nonlinear/coulomb.hpp"

#include "engine/model/block/declare.hpp"

namespace stepwire {

void Coulomb::declare(Declare<Coulomb>& is) {
  is.block(
      "Coulomb",
      {.doc =
           "Coulomb and viscous friction: y = coulomb sign(u) + viscous u with sign(0) = 0, or with "
           "tanh(u / smoothing) for the sign. Without smoothing a body at rest is not held: the sign flips "
           "from step to step. y points along u; subtract it from the forces.",
       .symbol = {.curve = "M-1 -.9L0 -.5V.5L1 .9", .axes = true}});
  is.parameter<&Coulomb::coulomb>({.unit = "'f", .doc = "dry friction", .at_least = 0.0});
  is.parameter<&Coulomb::viscous>({.unit = "'f/'v", .doc = "viscous friction per speed", .at_least = 0.0});
  is.parameter<&Coulomb::smoothing>(
      {.unit = "'v", .doc = "speed at which 76 % of the dry friction act; 0: all at once", .at_least = 0.0});
  is.input<&Coulomb::u>({.unit = "'v", .doc = "speed"});
  is.crossing<&Coulomb::u>("the speed passes 0, where the sign is not smoothed");
  is.output<&Coulomb::y>({.unit = "'f", .doc = "friction, with the sign of the speed"});
  is.state<&Coulomb::side>({.doc = "sign of the speed", .settable = false, .mode = true});
  is.derived<&Coulomb::holds_side>();
}

void Coulomb::configure(Configure& is) {
  is.hold_mode(holds_side);
}

}  // namespace stepwire
