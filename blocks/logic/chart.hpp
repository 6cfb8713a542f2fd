#pragma once

#include <string>
#include <vector>

#include "engine/base/expression/expression.hpp"
#include "engine/base/math/function.hpp"

namespace stepwire {

/// A formula of a StateMachine: variable i is the number at places[i] of what the machine knows.
struct ChartFormula {
  expression::Expression formula;
  std::vector<std::size_t> places;
};

/// A counter that is given a value.
struct ChartSetting {
  std::size_t counter;
  ChartFormula value;
};

struct ChartTransition {
  std::size_t target;  ///< a state, which may hold others
  ChartFormula guard;
  std::vector<ChartSetting> set;
};

/// A state of a StateMachine, as its file has it. States stand in the order of the file, each behind the one
/// that holds it.
struct ChartState {
  static constexpr std::size_t none = static_cast<std::size_t>(-1);

  std::string name;  ///< with those of the states that hold it: "on.fast"
  std::size_t parent = none, initial = none;
  bool history = false;
  std::vector<double> output;
  std::vector<ChartSetting> enter, exit, each;
  std::vector<ChartTransition> to;  ///< in the order in which they are tried
};

/// One of many formulas, by a number among those that it is a function of.
Function choice_of(std::vector<ChartFormula> formulas, std::size_t place_of_choice);

}  // namespace stepwire
