#pragma once

#include <string>
#include <vector>

#include "engine/base/expression/expression.hpp"
#include "engine/base/math/function.hpp"

namespace stepwire {

/// A formula of the inputs of a StateMachine and, behind them, the time in the state: variable i is the
/// number at places[i].
struct Guard {
  expression::Expression formula;
  std::vector<std::size_t> places;
};

struct Transition {
  std::size_t target;
  Guard guard;
};

/// A state of a StateMachine, as its file has it.
struct Stage {
  std::string name;
  std::vector<double> output;
  std::vector<Transition> to;
};

/// Which stage follows on which: of the inputs, the time in the stage, and the stage's index.
Function successor_among(const std::vector<Stage>& stages, std::size_t inputs);

}  // namespace stepwire
