#include "blocks/continuous/state_space.hpp"

#include "engine/model/block/declare_reset.hpp"

namespace stepwire {

void StateSpace::declare(Declare<StateSpace>& is) {
  is.block("StateSpace",
           {.doc = "Linear system with several inputs and outputs: dx/dt = A x + B u, y = C x + D u. Its "
                   "numbers are SI of what is wired; units are not checked through it.",
            .symbol = {.text = "ẋ = Ax + Bu\ny = Cx + Du"},
            .smooth = true});
  is.parameter<&StateSpace::A>({.unit = "*", .shape = "n x n", .doc = "system matrix", .required = true});
  is.parameter<&StateSpace::B>({.unit = "*", .shape = "n x m", .doc = "input matrix", .required = true});
  is.parameter<&StateSpace::C>({.unit = "*", .shape = "p x n", .doc = "output matrix", .required = true});
  is.parameter<&StateSpace::D>(
      {.unit = "*", .shape = "p x m", .doc = "what passes straight through; zero where left out"});
  is.input<&StateSpace::u>({.unit = "*", .shape = "m", .doc = "inputs"});
  is.output<&StateSpace::y>({.unit = "*", .shape = "p", .doc = "outputs"});
  is.state<&StateSpace::x>({.unit = "*", .shape = "n", .doc = "states"});
  declare_reset(is, "*", "the states", "n");
  is.derived<&StateSpace::direct, &StateSpace::D>();
}

void StateSpace::configure(Configure& is) {
  direct = std::any_of(D.elements().begin(), D.elements().end(), [](double d) { return d != 0.0; });
  if (!configure_reset(*this, is)) is.skip_update();
  is.feedthrough<&StateSpace::u, &StateSpace::y>(direct);
}

}  // namespace stepwire
