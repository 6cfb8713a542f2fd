#pragma once

#include <map>
#include <set>
#include <utility>

#include "engine/model/plan/plan.hpp"

namespace stepwire::fmu {

/// Instantaneous dependencies of signals: the diagram inputs and the blocks with continuous states that
/// affect a signal at the same instant.
class Dependencies {
 public:
  explicit Dependencies(const plan::Plan& plan) : plan_(plan) {}

  const std::set<int>& of_output(int block, int output);
  std::set<int> of(const diagram::SignalRef& signal);
  /// Returns the dependencies of the derivatives of a block's states.
  std::set<int> of_slopes(int block);

 private:
  bool feeds_through(int block, std::size_t input, int output) const;
  void add_input(int block, std::size_t input, std::set<int>& to);
  void add_own(int block, std::set<int>& to) const;

  const plan::Plan& plan_;
  std::map<std::pair<int, int>, std::set<int>> known_;
};

}  // namespace stepwire::fmu
