#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "engine/model/plan/change.hpp"
#include "engine/simulate/run/bound_blocks.hpp"

namespace stepwire::run {

/// Sets values of a run between two ticks. Dependent values are evaluated, configured and prepared as by a
/// run that begins with these values.
class ValueSetter {
 public:
  explicit ValueSetter(BoundBlocks& blocks) : blocks_(blocks), plan_(blocks.plan()) {}

  /// Sets one value for each name. Returns the indices of the blocks that were rebuilt, or std::nullopt if
  /// the values need another plan. In that case, and if it throws Error for a refused value, the run is
  /// unchanged. Allocates.
  [[nodiscard]] std::optional<std::vector<std::size_t>> set(const diagram::Variation& variation,
                                                            std::span<const diagram::Assignment> values);
  /// Returns the reason why the last set() needs another plan.
  const std::string& structure_change() const { return structure_change_; }
  /// Returns the present value of a parameter, by its index in Diagram::parameters.
  const Value& parameter(std::size_t index) const;
  /// Returns the blocks of which values were set.
  const plan::WrittenBlocks& written() const { return written_; }
  /// Writes the present values into a copy of the plan's diagram.
  void put_values(diagram::Diagram& diagram) const;

 private:
  std::vector<std::size_t> apply(plan::PlanChange& change);

  BoundBlocks& blocks_;
  const plan::Plan& plan_;
  std::optional<diagram::ParameterState> parameters_;  ///< present once a parameter is set
  plan::WrittenBlocks written_;
  std::string structure_change_;
};

}  // namespace stepwire::run
