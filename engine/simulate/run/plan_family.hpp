#pragma once

#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "engine/model/diagram/load.hpp"
#include "engine/simulate/run/executor.hpp"

namespace stepwire::run {

class PlanMember;
class MemberTrial;
class MemberTrials;

/// The plans of one file for values that a sweep, a study or a fit sets: one plan serves all values that
/// leave its structure as it is, and each other structure gets a plan of its own. Its calls may come from any
/// thread.
class PlanFamily {
 public:
  using ValuesOfRun = std::function<std::vector<diagram::Setting>(std::size_t run)>;

  /// `base` is the plan of the file with `settings`. The loader must outlive the calls of find().
  PlanFamily(diagram::Loader& loader, std::string file, std::vector<diagram::Setting> settings,
             const plan::Plan& base);
  ~PlanFamily();

  /// The member whose plan fits these values, each of another name; where there is none, the file is planned
  /// anew. Throws Error where the values are refused.
  std::size_t find(const std::vector<diagram::Setting>& values);
  /// The members of so many runs, whose values `values_of` names, found on so many threads (0: all cores);
  /// the same ones at any number of them. Throws as find() does, of the first run that is refused, and names
  /// it.
  std::vector<std::size_t> find_all(std::size_t runs, const ValuesOfRun& values_of, unsigned threads);

  std::size_t size() const;
  const plan::Plan& plan(std::size_t member) const;
  /// The values of blocks that a run of a member sets.
  const std::vector<diagram::Target>& targets(std::size_t member) const;
  /// What differs between the runs of a member's plan, of those values that find() has seen. Members that set
  /// other names in one plan share its code.
  std::vector<plan::VariableBlock> variable(std::size_t member) const;
  /// Sets the values of a run, for which find() gave this member, and puts it at time 0.
  void begin(std::size_t member, const std::vector<diagram::Setting>& values, Executor& run) const;

 private:
  std::vector<std::optional<std::size_t>> find_known(std::size_t first, std::size_t runs,
                                                     const ValuesOfRun& values_of, MemberTrials& trials,
                                                     unsigned threads);
  std::size_t find_named(const std::vector<diagram::Setting>& values);
  std::optional<std::size_t> known(const std::vector<diagram::Setting>& values, MemberTrial& trial) const;
  std::size_t add(std::unique_ptr<PlanMember> member);
  PlanMember& member(std::size_t index) const;
  std::shared_ptr<const plan::Plan> plan_anew(const std::vector<diagram::Setting>& values) const;

  diagram::Loader& loader_;
  std::string file_;
  std::vector<diagram::Setting> settings_;
  std::shared_ptr<const plan::Plan> base_;
  mutable std::mutex finding_;  ///< one find() at a time, which alone adds members
  mutable std::mutex looking_;  ///< the list of members itself
  std::vector<std::unique_ptr<PlanMember>> members_;
  std::unique_ptr<MemberTrial> trial_;  ///< of find()
};

/// Runs of a family that wait to be used again, so that a new one is made only for another thread.
class IdleRuns {
 public:
  explicit IdleRuns(const PlanFamily& family) : family_(family) {}

  std::unique_ptr<Executor> take(std::size_t member);
  void give_back(std::size_t member, std::unique_ptr<Executor> run);

 private:
  const PlanFamily& family_;
  std::mutex mutex_;
  std::vector<std::vector<std::unique_ptr<Executor>>> idle_;  ///< of each member
};

}  // namespace stepwire::run
