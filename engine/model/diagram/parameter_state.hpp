#pragma once

#include <map>
#include <span>
#include <utility>
#include <vector>

#include "engine/model/diagram/variation.hpp"

namespace stepwire::diagram {

/// A changed value of a block.
struct ChangedValue {
  Target target;
  WrittenValue value;
  Origin origin;  ///< location of its text
};

/// Current parameter values of one run of a diagram. The diagram must outlive it.
class ParameterState {
 public:
  explicit ParameterState(const Diagram& diagram) : diagram_(diagram) {}

  /// Sets values, one for each name of the variation, and evaluates all that depend on them. Values set
  /// earlier by their own name are kept. On a fault it throws Error with all faults and changes no value.
  std::vector<ChangedValue> set(const Variation& variation, std::span<const Assignment> values);
  /// Returns the value of a parameter by its index in Diagram::parameters; nullptr for the diagram's own
  /// value.
  const Value* value(std::size_t definition) const;
  /// Reverts the last set().
  void undo();

 private:
  class Evaluation;

  /// Returns the run's own copy of a scope, since reading records uses in it.
  ParameterScope& scope(int index);
  void replace(const Definition& definition, WrittenValue value);

  const Diagram& diagram_;
  std::map<int, ParameterScope> scopes_;
  std::vector<int> set_definitions_;  ///< that no longer depend on other parameters
  std::vector<Target> set_targets_;
  std::vector<std::pair<const Definition*, WrittenValue>> before_;  ///< previous values of the last set()
  std::size_t definitions_before_ = 0, targets_before_ = 0;
};

}  // namespace stepwire::diagram
