#include "blocks/discrete/discrete_state_space.hpp"

#include <algorithm>

#include "engine/model/block/declare_reset.hpp"

namespace stepwire {

void DiscreteStateSpace::declare(Declare<DiscreteStateSpace>& is) {
  using Block = DiscreteStateSpace;
  is.block("DiscreteStateSpace",
           {.doc = "Linear system with several inputs and outputs at its ticks: x[k+1] = A x[k] + B u[k], "
                   "y[k] = C x[k] + D u[k]. Its numbers are SI of what is wired; units are not checked "
                   "through it. A continuous system becomes one by c2d.",
            .source = "Åström, Wittenmark, Computer-Controlled Systems, 1997, section 2.3",
            .symbol = {.text = "x⁺ = Ax + Bu\ny = Cx + Du"}});
  is.parameter<&Block::A>({.unit = "*", .shape = "n x n", .doc = "system matrix", .required = true});
  is.parameter<&Block::B>({.unit = "*", .shape = "n x m", .doc = "input matrix", .required = true});
  is.parameter<&Block::C>({.unit = "*", .shape = "p x n", .doc = "output matrix", .required = true});
  is.parameter<&Block::D>(
      {.unit = "*", .shape = "p x m", .doc = "what passes straight through; zero where left out"});
  is.input<&Block::u>({.unit = "*", .shape = "m", .doc = "inputs; felt at once only through D"});
  is.output<&Block::y>({.unit = "*", .shape = "p", .doc = "outputs"});
  is.state<&Block::x>({.unit = "*", .shape = "n", .doc = "states"});
  is.state<&Block::next>({.unit = "*", .shape = "n", .doc = "states of the next tick", .settable = false});
  declare_reset(is, "*", "the states", "n");
  is.derived<&Block::direct, &Block::D>();
}

void DiscreteStateSpace::configure(Configure& is) {
  configure_reset(*this, is);
  direct = std::any_of(D.elements().begin(), D.elements().end(), [](double d) { return d != 0.0; });
  is.feedthrough<&DiscreteStateSpace::u, &DiscreteStateSpace::y>(direct);
}

}  // namespace stepwire
