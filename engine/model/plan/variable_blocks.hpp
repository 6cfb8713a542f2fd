#pragma once

#include <functional>
#include <vector>

#include "engine/model/diagram/variation.hpp"
#include "engine/model/plan/plan.hpp"

namespace stepwire::plan {

/// A block of which compiled code reads items from a table; all others stand in the code as the plan has
/// them.
struct VariableBlock {
  std::size_t block;
  std::vector<bool> items;  ///< which of its MemberItems
};

/// The i-th block of a plan as a run has it.
using BlocksOfRun = std::function<const void*(std::size_t)>;

/// The items that may differ between runs of a variation, in the order of memory: the parameters that it sets
/// and all that their blocks compute, but no length of a list. A length, or another parameter that a block
/// changes, is found by the run (NumberTable::read), and widen() adds it.
std::vector<VariableBlock> variable_blocks(const Plan& plan, const diagram::Variation& variation);

/// Adds what varies in other runs of the plan.
void unite(std::vector<VariableBlock>& variable, const Plan& plan, const std::vector<VariableBlock>& more);

/// Adds the items in which the blocks of a run differ from those of the plan.
void widen(std::vector<VariableBlock>& variable, const Plan& plan, const BlocksOfRun& blocks);

}  // namespace stepwire::plan
