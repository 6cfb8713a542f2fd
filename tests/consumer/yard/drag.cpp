#include "yard/drag.hpp"

#include <stepwire/declare.hpp>

namespace yard {

void Drag::declare(stepwire::Declare<Drag>& is) {
  is.block("Drag", {.doc = "Drag of a flow: F = -c v |v|."});
  is.parameter<&Drag::c>({.unit = "N s^2/m^2", .doc = "coefficient", .at_least = 0.0});
  is.input<&Drag::v>({.unit = "m/s", .doc = "speed"});
  is.output<&Drag::F>({.unit = "N", .doc = "force"});
}

}  // namespace yard
