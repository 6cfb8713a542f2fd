#pragma once

#include <string>
#include <vector>

#include "blocks/logic/chart.hpp"
#include "engine/model/block/value.hpp"

namespace stepwire {

/// Reads the states of a StateMachine from its file and checks them.
class ChartReader {
 public:
  static constexpr std::size_t none = ChartState::none;

  ChartReader(const Value& tree, ChartNames names, ChartRefuse refuse);

  const std::vector<ChartState>& states() const { return states_; }
  /// Returns the state with this name, which may be relative to a state or qualified by the enclosing states;
  /// `none` if there is no such state.
  std::size_t find(const std::string& name, std::size_t from = none) const;
  std::string names() const;
  std::size_t leaf_of(std::size_t state) const;
  void refuse_unreachable(std::size_t first) const;

 private:
  void gather(const Value& map, std::size_t parent);
  void read_state(std::size_t state);
  void read_key(std::size_t state, const std::string& key, const Value& value);
  void read_history(std::size_t state, const Value& value);
  std::size_t initial_of(std::size_t state) const;
  std::vector<double> read_output(const std::string& name, const Value& tree) const;
  std::vector<ChartTransition> read_map(std::size_t from, const Value& map) const;
  std::vector<ChartTransition> read_list(std::size_t from, const Value& list) const;
  ChartTransition read_transition(std::size_t from, const Value& entry) const;
  std::vector<ChartTransition> read_timeouts(std::size_t from, const Value& map) const;
  std::size_t target(std::size_t from, const std::string& name, const Value& where) const;
  void level_outputs();

  const Value& tree_;
  ChartFormulas formulas_;
  ChartRefuse refuse_;
  std::vector<ChartState> states_;
  std::vector<const Value*> trees_;  ///< of each state
};

}  // namespace stepwire
