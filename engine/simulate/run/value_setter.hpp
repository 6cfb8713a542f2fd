#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "engine/model/plan/change.hpp"
#include "engine/simulate/run/bound_blocks.hpp"

namespace stepwire::run {

/// Sets values of a run between two ticks: what follows from them is evaluated, configured and prepared as
/// by a run that begins with these values.
class ValueSetter {
 public:
  explicit ValueSetter(BoundBlocks& blocks) : blocks_(blocks), plan_(blocks.plan()) {}

  /// One value for each name. Gives the blocks that are made anew; empty where the values need another
  /// plan. Then, and where a value is refused (throws Error), everything stays as it was. Allocates.
  [[nodiscard]] std::optional<std::vector<std::size_t>> set(const diagram::Variation& variation,
                                                            std::span<const diagram::Assignment> values);
  /// Why the last set() needs another plan.
  const std::string& structure_change() const { return structure_change_; }
  /// The present value of a parameter of the diagram, by its index in Diagram::parameters.
  const Value& parameter(std::size_t index) const;
  /// Blocks of which values were set.
  const plan::WrittenBlocks& written() const { return written_; }
  /// Puts the values that are set now into a copy of the plan's diagram.
  void put_values(diagram::Diagram& diagram) const;

 private:
  std::vector<std::size_t> apply(plan::PlanChange& change);

  BoundBlocks& blocks_;
  const plan::Plan& plan_;
  std::optional<diagram::ParameterState> parameters_;  ///< once one is set
  plan::WrittenBlocks written_;
  std::string structure_change_;
};

}  // namespace stepwire::run
