#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "engine/model/diagram/parameter_state.hpp"
#include "engine/model/plan/plan.hpp"

namespace stepwire::plan {

/// A block of a plan with other values.
struct RebuiltBlock {
  std::size_t block;
  AnyBlock written;  ///< as files would give it
  AnyBlock made;     ///< and as it is run
};

/// What becomes different in a run of a plan when values change.
struct PlanChange {
  std::vector<RebuiltBlock> blocks;
  std::vector<std::pair<SignalSlot, Eigen::VectorXd>> constants;  ///< on wires, of one number or all
  std::vector<std::pair<SignalSlot, Eigen::VectorXd>> initial;    ///< of states
  /// Why the plan does not fit the values, whose own plan has another structure; empty where it does.
  std::string structure;
};

/// Blocks as files would give them, where they are not what the plan has; by their index.
using WrittenBlocks = std::map<std::size_t, AnyBlock>;

/// Throws Error where a block refuses its parameters.
PlanChange change_of(const Plan& plan, const std::vector<diagram::ChangedValue>& values,
                     const WrittenBlocks& written);

}  // namespace stepwire::plan
