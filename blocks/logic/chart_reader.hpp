#pragma once

#include <functional>
#include <string>
#include <vector>

#include "blocks/logic/chart.hpp"
#include "engine/model/block/value.hpp"

namespace stepwire {

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

/// Reads the states of a StateMachine from its file and checks them.
class ChartReader {
 public:
  /// `refuse` throws: what is wrong, and with which piece of the tree.
  using Refuse = std::function<void(const std::string& message, const Value& where)>;
  static constexpr std::size_t none = ChartState::none;

  ChartReader(const Value& tree, ChartNames names, Refuse refuse);

  const std::vector<ChartState>& states() const { return states_; }
  /// The state of a name as it stands in the file or with those that hold it; or none.
  std::size_t find(const std::string& name, std::size_t from = none) const;
  std::string names() const;
  std::size_t leaf_of(std::size_t state) const;
  void refuse_unreachable(std::size_t first) const;

 private:
  void gather(const Value& map, std::size_t parent);
  void read_state(std::size_t state);
  void read_key(std::size_t state, const std::string& key, const Value& value);
  std::size_t initial_of(std::size_t state) const;
  std::vector<double> read_output(const std::string& name, const Value& tree) const;
  double read_number(const std::string& name, const Value& tree) const;
  std::vector<ChartTransition> read_map(std::size_t from, const Value& map) const;
  std::vector<ChartTransition> read_list(std::size_t from, const Value& list) const;
  std::vector<ChartTransition> read_timeouts(std::size_t from, const Value& map) const;
  std::size_t target(std::size_t from, const std::string& name, const Value& where) const;
  std::vector<ChartSetting> read_settings(const std::string& subject, const Value& map) const;
  ChartFormula read_formula(const std::string& subject, const std::string& text, const Value& where) const;
  void level_outputs();

  const Value& tree_;
  ChartNames names_;
  Refuse refuse_;
  std::vector<ChartState> states_;
  std::vector<const Value*> trees_;  ///< of each state
};

}  // namespace stepwire
