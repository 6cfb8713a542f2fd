#include "blocks/continuous/state_space.hpp"

#include "engine/model/block/declare_linear_system.hpp"

namespace stepwire {

void StateSpace::declare(Declare<StateSpace>& is) {
  is.block("StateSpace",
           {.doc = "Linear system with several inputs and outputs: dx/dt = A x + B u, y = C x + D u. Its "
                   "numbers are SI of what is wired; units are not checked through it.",
            .discrete = "DiscreteStateSpace",
            .symbol = {.text = "ẋ = Ax + Bu\ny = Cx + Du"},
            .smooth = true});
  declare_linear_system(is, false);
  is.input<&StateSpace::u>({.unit = "*", .shape = "m", .doc = "inputs"});
  is.output<&StateSpace::y>({.unit = "*", .shape = "p", .doc = "outputs"});
  is.state<&StateSpace::x>({.unit = "*", .shape = "n", .doc = "states"});
  declare_reset(is, "*", "the states", "n");
}

void StateSpace::configure(Configure& is) {
  configure_linear_system(*this, is);
  if (!configure_reset(*this, is)) is.skip_update();
  is.feedthrough<&StateSpace::u, &StateSpace::y>(direct);
}

}  // namespace stepwire
