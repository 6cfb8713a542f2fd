#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "engine/model/diagram/parameter_state.hpp"
#include "engine/model/plan/plan.hpp"

namespace stepwire::plan {

/// A block of a plan with new values.
struct RebuiltBlock {
  std::size_t block;
  AnyBlock written;  ///< as given by the files
  AnyBlock made;     ///< after configure() and prepare()
};

/// Changes in a run of a plan after new values.
struct PlanChange {
  std::vector<RebuiltBlock> blocks;
  std::vector<std::pair<SignalSlot, Eigen::VectorXd>> constants;  ///< on wires; one number or all elements
  std::vector<std::pair<SignalSlot, Eigen::VectorXd>> initial;    ///< initial values of states
  /// Reason why the values need a plan of another structure; empty if this plan fits.
  std::string structure;
};

/// Blocks as given by files that differ from the plan, by their index.
using WrittenBlocks = std::map<std::size_t, AnyBlock>;

/// Computes the changes for new values. Throws Error where a block refuses its parameters.
PlanChange change_of(const Plan& plan, const std::vector<diagram::ChangedValue>& values,
                     const WrittenBlocks& written);

}  // namespace stepwire::plan
