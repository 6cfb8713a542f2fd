#pragma once

#include <functional>
#include <string>
#include <vector>

#include "engine/base/expression/expression.hpp"
#include "engine/base/math/function.hpp"
#include "engine/model/block/value.hpp"

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

/// What formulas of a chart may name, and where the numbers are: inputs, counters, the time in the state.
struct ChartNames {
  std::vector<std::string> inputs;  ///< empty: u1, u2, ... (u where there is one)
  std::size_t input_count = 0;
  std::vector<std::string> counters;

  static constexpr std::size_t none = static_cast<std::size_t>(-1);
  std::size_t place(std::string_view name) const;  ///< or none
  std::size_t counter(std::string_view name) const;
  std::size_t after() const { return input_count + counters.size(); }
  std::string text() const;  ///< for people
};

/// Throws: what is wrong, and with which piece of the tree.
using ChartRefuse = std::function<void(const std::string& message, const Value& where)>;

/// Reads the formulas and numbers of a chart and checks them.
class ChartFormulas {
 public:
  ChartFormulas(ChartNames names, ChartRefuse refuse);

  ChartFormula read(const std::string& subject, const std::string& text, const Value& where) const;
  std::vector<ChartSetting> settings(const std::string& subject, const Value& map) const;
  double number(const std::string& state, const Value& tree) const;  ///< finite

 private:
  ChartNames names_;
  ChartRefuse refuse_;
};

/// One of many formulas, by a number among those that it is a function of.
Function choice_of(std::vector<ChartFormula> formulas, std::size_t place_of_choice);

}  // namespace stepwire
