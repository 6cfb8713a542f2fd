#pragma once

#include <set>
#include <utility>
#include <vector>

#include "engine/model/plan/plan.hpp"

namespace stepwire::fmu {

/// Instantaneous dependencies of signals: the diagram inputs and the blocks with continuous states that
/// affect a signal at the same instant.
class Dependencies {
 public:
  explicit Dependencies(const plan::Plan& plan) : plan_(plan) {}

  std::set<int> of(const diagram::SignalRef& signal) const;
  /// Returns the dependencies of the derivatives of a block's states.
  std::set<int> of_slopes(int block) const;

 private:
  using Output = std::pair<int, int>;  ///< a block and the number of its output

  /// Returns the dependencies of outputs. A search over the wires meets each output once, also in an
  /// algebraic loop.
  std::set<int> of_outputs(std::vector<Output> open) const;
  std::vector<Output> sources_of(int block, std::size_t input) const;
  bool feeds_through(int block, std::size_t input, int output) const;
  void add_own(int block, std::set<int>& to) const;

  const plan::Plan& plan_;
};

}  // namespace stepwire::fmu
