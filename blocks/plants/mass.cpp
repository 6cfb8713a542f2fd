#include "blocks/plants/mass.hpp"

#include "engine/model/block/declare.hpp"

namespace stepwire {

void Mass::declare(Declare<Mass>& is) {
  is.block("Mass", {.doc = "A point mass on a line, or along several axes: m dv/dt = F, dx/dt = v."});
  is.parameter<&Mass::mass>({.unit = "kg", .doc = "moving mass", .above = 0.0});
  is.input<&Mass::force>({.unit = "N", .doc = "sum of the forces on the mass", .feedthrough = false});
  is.output<&Mass::position, &Mass::position_>({.unit = "m", .doc = "position"});
  is.output<&Mass::velocity, &Mass::velocity_>({.unit = "m/s", .doc = "velocity"});
  is.state<&Mass::position_>({.unit = "m", .doc = "position"});
  is.state<&Mass::velocity_>({.unit = "m/s", .doc = "velocity"});
}

}  // namespace stepwire
