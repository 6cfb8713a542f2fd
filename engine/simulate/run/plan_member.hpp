#pragma once

#include <memory>
#include <mutex>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "engine/model/diagram/load.hpp"
#include "engine/model/diagram/variation.hpp"
#include "engine/simulate/run/executor.hpp"

namespace stepwire::run {

std::vector<std::string> names_of(const std::vector<diagram::Setting>& values);

/// Plan of a family, the names that its runs set, and the values that its runs share because they decide the
/// structure.
class PlanMember {
 public:
  /// `values` are those of one run.
  PlanMember(std::shared_ptr<const plan::Plan> of, const std::vector<diagram::Setting>& values);

  /// True if these values have this member's names and structural values. They may still be refused when set.
  bool may_take(const std::vector<diagram::Setting>& values) const;
  /// Sets the values in a run of the plan.
  Executor::Setting set(const std::vector<diagram::Setting>& values, Executor& run) const;
  /// True if one of its names decides the structure.
  bool is_structural() const { return all_.structural(); }

  const std::shared_ptr<const plan::Plan>& plan() const { return plan_; }
  const std::vector<std::string>& names() const { return names_; }
  /// Returns the values of blocks that a run sets.
  const std::vector<diagram::Target>& targets() const { return free_.targets(); }
  /// Returns the differences between the runs so far.
  const std::vector<plan::VariableBlock>& variable() const { return variable_; }
  void widen(const std::vector<plan::VariableBlock>& more);

 private:
  std::vector<std::string> names_to_set() const;

  std::shared_ptr<const plan::Plan> plan_;
  std::vector<std::string> names_;
  diagram::Variation all_;              ///< all names
  diagram::Variation free_;             ///< names that are set in a run of the plan
  std::vector<std::string> structure_;  ///< values of structural names; "" for the others
  std::vector<plan::VariableBlock> variable_;
};

/// One executor of each member, in which values are tried, and the differences that were found. Not
/// thread-safe.
class MemberTrial {
 public:
  /// True if a run of the member, which must outlive the trial, can have these values. Throws Error for
  /// refused values.
  bool takes(const PlanMember& member, const std::vector<diagram::Setting>& values);
  /// Adds the differences between the tried values to a member.
  void add_to(PlanMember& member) const;

 private:
  struct Tried {
    std::unique_ptr<Executor> run;
    std::vector<plan::VariableBlock> variable;
  };

  std::unordered_map<const PlanMember*, Tried> tried_;
};

/// Pool of trials, one for each concurrent thread.
class MemberTrials {
 public:
  template <class Work>
  void use(const Work& work) {
    std::unique_ptr<MemberTrial> trial = take();
    work(*trial);
    const std::lock_guard lock(mutex_);
    idle_.push_back(std::move(trial));
  }

  /// Returns all trials, while none is in use.
  const std::vector<std::unique_ptr<MemberTrial>>& all() const { return idle_; }

 private:
  std::unique_ptr<MemberTrial> take();

  std::mutex mutex_;
  std::vector<std::unique_ptr<MemberTrial>> idle_;
};

}  // namespace stepwire::run
