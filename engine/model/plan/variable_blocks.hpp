#pragma once

#include <functional>
#include <vector>

#include "engine/model/diagram/variation.hpp"
#include "engine/model/plan/plan.hpp"

namespace stepwire::plan {

/// A block of which compiled code reads items from a table; its other items are literals in the code.
struct VariableBlock {
  std::size_t block;
  std::vector<bool> items;  ///< which of its MemberItems
};

/// Function that returns the i-th block of a plan in a run.
using BlocksOfRun = std::function<const void*(std::size_t)>;

/// Returns the items that may differ between runs of a variation, in the order of memory. They are the
/// parameters that it sets and all that their blocks compute, except lengths of lists. The run detects
/// changed lengths and other changed parameters (NumberTable::read), and widen() adds them.
std::vector<VariableBlock> variable_blocks(const Plan& plan, const diagram::Variation& variation);

/// Adds the items that vary in other runs of the plan.
void unite(std::vector<VariableBlock>& variable, const Plan& plan, const std::vector<VariableBlock>& more);

/// Adds the items in which the blocks of a run differ from those of the plan.
void widen(std::vector<VariableBlock>& variable, const Plan& plan, const BlocksOfRun& blocks);

}  // namespace stepwire::plan
