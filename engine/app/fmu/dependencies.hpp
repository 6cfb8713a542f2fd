#pragma once

#include <map>
#include <set>
#include <utility>

#include "engine/model/plan/plan.hpp"

namespace stepwire::fmu {

/// On which blocks a signal depends at an instant: inputs of the diagram, and blocks with continuous states.
class Dependencies {
 public:
  explicit Dependencies(const plan::Plan& plan) : plan_(plan) {}

  const std::set<int>& of_output(int block, int output);
  std::set<int> of(const diagram::SignalRef& signal);
  /// Of the slopes of a block.
  std::set<int> of_slopes(int block);

 private:
  bool feeds_through(int block, std::size_t input, int output) const;
  void add_input(int block, std::size_t input, std::set<int>& to);
  void add_own(int block, std::set<int>& to) const;

  const plan::Plan& plan_;
  std::map<std::pair<int, int>, std::set<int>> known_;
};

}  // namespace stepwire::fmu
