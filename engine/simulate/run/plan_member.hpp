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

/// A plan of a family, what its runs set, and what they share: the values that decide its structure.
class PlanMember {
 public:
  /// `values` are those of one run.
  PlanMember(std::shared_ptr<const plan::Plan> of, const std::vector<diagram::Setting>& values);

  /// May a run of this member have these values?
  bool may_take(const std::vector<diagram::Setting>& values) const;
  /// Sets them in a run of the plan.
  Executor::Setting set(const std::vector<diagram::Setting>& values, Executor& run) const;
  /// Does one of its names decide the structure?
  bool is_structural() const { return all_.structural(); }

  const std::shared_ptr<const plan::Plan>& plan() const { return plan_; }
  const std::vector<std::string>& names() const { return names_; }
  /// The values of blocks that a run sets.
  const std::vector<diagram::Target>& targets() const { return free_.targets(); }
  /// What has differed between the runs so far.
  const std::vector<plan::VariableBlock>& variable() const { return variable_; }
  void widen(const std::vector<plan::VariableBlock>& more);

 private:
  std::vector<std::string> names_to_set() const;

  std::shared_ptr<const plan::Plan> plan_;
  std::vector<std::string> names_;
  diagram::Variation all_;              ///< of all names
  diagram::Variation free_;             ///< of those that are set in a run of the plan
  std::vector<std::string> structure_;  ///< values of structural names; "" of others
  std::vector<plan::VariableBlock> variable_;
};

/// Runs in which values are tried, one of each member, and what these have shown to differ. For one thread.
class MemberTrial {
 public:
  /// Can a run of the member, which outlives the trial, have these values? Throws Error where they are
  /// refused.
  bool takes(const PlanMember& member, const std::vector<diagram::Setting>& values);
  /// Adds to a member what has differed between the values that it took here.
  void add_to(PlanMember& member) const;

 private:
  struct Tried {
    std::unique_ptr<Executor> run;
    std::vector<plan::VariableBlock> variable;
  };

  std::unordered_map<const PlanMember*, Tried> tried_;
};

/// A trial for each thread that works at once.
class MemberTrials {
 public:
  template <class Work>
  void use(const Work& work) {
    std::unique_ptr<MemberTrial> trial = take();
    work(*trial);
    const std::lock_guard lock(mutex_);
    idle_.push_back(std::move(trial));
  }

  /// All, while none is in use.
  const std::vector<std::unique_ptr<MemberTrial>>& all() const { return idle_; }

 private:
  std::unique_ptr<MemberTrial> take();

  std::mutex mutex_;
  std::vector<std::unique_ptr<MemberTrial>> idle_;
};

}  // namespace stepwire::run
