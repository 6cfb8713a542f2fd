#pragma once

#include <functional>
#include <string>
#include <vector>

#include "engine/base/expression/expression.hpp"
#include "engine/base/math/function.hpp"
#include "engine/model/block/value.hpp"

namespace stepwire {

/// Formula of a StateMachine: variable i is the number at places[i] of the machine's variables.
struct ChartFormula {
  expression::Expression formula;
  std::vector<std::size_t> places;
};

/// Assignment to a counter.
struct ChartSetting {
  std::size_t counter;
  ChartFormula value;
};

struct ChartTransition {
  std::size_t target;  ///< state, which may hold others
  ChartFormula guard;
  std::vector<ChartSetting> set;
};

/// State of a StateMachine in its file. States are in the order of the file, each after the one that holds
/// it.
struct ChartState {
  static constexpr std::size_t none = static_cast<std::size_t>(-1);

  std::string name;  ///< with those of the enclosing states: "on.fast"
  std::size_t parent = none, initial = none;
  bool history = false;
  std::vector<double> output;
  std::vector<ChartSetting> enter, exit, each;
  std::vector<ChartTransition> to;  ///< in order of priority
};

/// Variables of the formulas of a chart and their places: inputs, counters, the time in the state.
struct ChartNames {
  std::vector<std::string> inputs;  ///< empty: u1, u2, ... (u for a single one)
  std::size_t input_count = 0;
  std::vector<std::string> counters;

  static constexpr std::size_t none = static_cast<std::size_t>(-1);
  std::size_t place(std::string_view name) const;  ///< returns `none` for an unknown name
  std::size_t counter(std::string_view name) const;
  std::size_t after() const { return input_count + counters.size(); }
  std::string text() const;  ///< list for messages
};

/// Function that throws a message for a piece of the tree.
using ChartRefuse = std::function<void(const std::string& message, const Value& where)>;

/// Reads and checks the formulas and numbers of a chart.
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

/// Returns a function that selects one of many formulas by the number at `place_of_choice`.
Function choice_of(std::vector<ChartFormula> formulas, std::size_t place_of_choice);

}  // namespace stepwire
