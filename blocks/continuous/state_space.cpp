#include "blocks/continuous/state_space.hpp"

#include <fmt/format.h>

namespace stepwire {

void StateSpace::declare(Declare<StateSpace>& is) {
  is.block("StateSpace",
           {.doc = "Linear system with several inputs and outputs: dx/dt = A x + B u, y = C x + D u. Its "
                   "numbers are SI of what is wired; units are not checked through it."});
  is.parameter<&StateSpace::A>({.unit = "*", .shape = "n x n", .doc = "system matrix", .required = true});
  is.parameter<&StateSpace::B>({.unit = "*", .shape = "n x m", .doc = "input matrix", .required = true});
  is.parameter<&StateSpace::C>({.unit = "*", .shape = "p x n", .doc = "output matrix", .required = true});
  is.parameter<&StateSpace::D>(
      {.unit = "*", .doc = "p x m, what passes straight through; zero where left out"});
  is.input<&StateSpace::u>({.unit = "*", .shape = "m", .doc = "inputs"});
  is.output<&StateSpace::y>({.unit = "*", .shape = "p", .doc = "outputs"});
  is.state<&StateSpace::x>({.unit = "*", .shape = "n", .doc = "states"});
}

void StateSpace::configure(Configure& is) {
  const bool fits = D.rows() == C.rows() && D.cols() == B.cols();
  if (D.size() > 0 && !fits)
    is.refuse<&StateSpace::D>(fmt::format("it is {} x {}; with this B and C it must be {} x {}", D.rows(),
                                          D.cols(), C.rows(), B.cols()));
  direct = !D.isZero(0.0);
  is.feedthrough<&StateSpace::u, &StateSpace::y>(direct);
}

}  // namespace stepwire
