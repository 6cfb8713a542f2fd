#pragma once

#include <map>
#include <span>
#include <utility>
#include <vector>

#include "engine/model/diagram/variation.hpp"

namespace stepwire::diagram {

/// A value of a block that has changed.
struct ChangedValue {
  Target target;
  WrittenValue value;
  Origin origin;  ///< of its text
};

/// The parameters of one run of a diagram, with their values at present. The diagram must outlive it.
class ParameterState {
 public:
  explicit ParameterState(const Diagram& diagram) : diagram_(diagram) {}

  /// Sets values, one for each name of the variation, and evaluates what follows from them. What was set by
  /// its own name before keeps that value. Throws Error, with everything that is refused, and changes nothing
  /// then.
  std::vector<ChangedValue> set(const Variation& variation, std::span<const Assignment> values);
  /// The value of a parameter, by its index in Diagram::parameters; null where it is the diagram's own.
  const Value* value(std::size_t definition) const;
  /// Takes the last set() back.
  void undo();

 private:
  class Evaluation;

  /// A copy of its own, since reading notes what is used.
  ParameterScope& scope(int index);
  void replace(const Definition& definition, WrittenValue value);

  const Diagram& diagram_;
  std::map<int, ParameterScope> scopes_;
  std::vector<int> set_definitions_;  ///< that do not follow from others any more
  std::vector<Target> set_targets_;
  std::vector<std::pair<const Definition*, WrittenValue>> before_;  ///< the last set()
  std::size_t definitions_before_ = 0, targets_before_ = 0;
};

}  // namespace stepwire::diagram
