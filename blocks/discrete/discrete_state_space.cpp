#include "blocks/discrete/discrete_state_space.hpp"

#include "engine/model/block/declare_linear_system.hpp"

namespace stepwire {

void DiscreteStateSpace::declare(Declare<DiscreteStateSpace>& is) {
  using Block = DiscreteStateSpace;
  is.block("DiscreteStateSpace",
           {.doc = "Linear system with several inputs and outputs at its ticks: x[k+1] = A x[k] + B u[k], "
                   "y[k] = C x[k] + D u[k]. Its numbers are SI of what is wired; units are not checked "
                   "through it. A continuous system becomes one by c2d.",
            .source = "Åström, Wittenmark, Computer-Controlled Systems, 1997, section 2.3",
            .symbol = {.text = "x⁺ = Ax + Bu\ny = Cx + Du"}});
  declare_linear_system(is, false);
  is.input<&Block::u>({.unit = "*", .shape = "m", .doc = "inputs; felt at once only through D"});
  is.output<&Block::y>({.unit = "*", .shape = "p", .doc = "outputs"});
  is.state<&Block::x>({.unit = "*", .shape = "n", .doc = "states"});
  is.state<&Block::next>({.unit = "*", .shape = "n", .doc = "states of the next tick", .settable = false});
  declare_reset(is, "*", "the states", "n");
}

void DiscreteStateSpace::configure(Configure& is) {
  configure_reset(*this, is);
  configure_linear_system(*this, is);
  is.feedthrough<&DiscreteStateSpace::u, &DiscreteStateSpace::y>(direct);
}

}  // namespace stepwire
