#pragma once

#include "blocks/plants/dry_friction.hpp"
#include "engine/model/block/declare.hpp"

namespace stepwire {

/// Declares the parameters, ports and states of DryFriction.
template <class Block>
void declare_dry_friction(Declare<Block>& is) {
  is.template parameter<&Block::mass>(
      {.unit = "kg", .doc = "of the body, as in Mass", .above = 0.0, .required = true});
  is.template parameter<&Block::coulomb>(
      {.unit = "N", .doc = "friction of a motion", .at_least = 0.0, .required = true});
  is.template parameter<&Block::breakaway>(
      {.unit = "N",
       .doc = "what it takes to move a body at rest; `coulomb` where that is more",
       .at_least = 0.0});
  is.template parameter<&Block::viscous>(
      {.unit = "N s/m", .doc = "friction that grows with the speed", .at_least = 0.0});
  is.template parameter<&Block::stribeck>(
      {.unit = "m/s",
       .doc = "speed at which all but 1/e of the difference to `breakaway` is gone; 0: at once",
       .at_least = 0.0});
  is.template input<&Block::force>({.unit = "N", .doc = "sum of all other forces on the body"});
  is.template input<&Block::velocity>({.unit = "m/s", .doc = "of the body"});
  is.template output<&Block::y>({.unit = "N", .doc = "force of the friction on the body"});
  is.template output<&Block::slides>({.doc = "1 and -1 while it slides that way, 0 while it sticks"});
  is.template state<&Block::way>({.doc = "the same, as it was at the last instant", .settable = false});
  is.template state<&Block::rest>({.unit = "m/s", .doc = "velocity at the last instant", .settable = false});
  is.template clock<&Block::period>();
}

}  // namespace stepwire
