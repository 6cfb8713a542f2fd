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

/// Set of plans of one file, for the values that a sweep or a study sets.
///
/// Values that leave the structure unchanged share one plan; each other structure has its own. Thread-safe.
class PlanFamily {
 public:
  using ValuesOfRun = std::function<std::vector<diagram::Setting>(std::size_t run)>;

  /// `base` is the plan of the file with `settings`. The loader must outlive the calls of find().
  PlanFamily(diagram::Loader& loader, std::string file, std::vector<diagram::Setting> settings,
             const plan::Plan& base);
  ~PlanFamily();

  /// Returns the index of the member whose plan fits these values, each of another name. Plans the file again
  /// if no member fits. Throws Error for refused values.
  std::size_t find(const std::vector<diagram::Setting>& values);
  /// Finds the members of the first `runs` runs, with the values of `values_of`, on `threads` threads (0: all
  /// cores). The result is the same for any number of threads. Throws as find() does, for the first refused
  /// run, and names that run.
  std::vector<std::size_t> find_all(std::size_t runs, const ValuesOfRun& values_of, unsigned threads);

  std::size_t size() const;
  const plan::Plan& plan(std::size_t member) const;
  /// Returns the values of blocks that a run of a member sets.
  const std::vector<diagram::Target>& targets(std::size_t member) const;
  /// Returns the differences between the runs of a member's plan, for the values that find() has seen.
  /// Members that set other names on the same plan share its code.
  std::vector<plan::VariableBlock> variable(std::size_t member) const;
  /// Sets the values of a run, for which find() returned this member, and resets it to time 0.
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
  mutable std::mutex finding_;  ///< serialises find(), which alone adds members
  mutable std::mutex looking_;  ///< guards the list of members
  std::vector<std::unique_ptr<PlanMember>> members_;
  std::unique_ptr<MemberTrial> trial_;  ///< used by find()
};

/// Pool of executors of a family. A new one is made only if all executors of a member are in use.
class IdleRuns {
 public:
  explicit IdleRuns(const PlanFamily& family) : family_(family) {}

  std::unique_ptr<Executor> take(std::size_t member);
  void give_back(std::size_t member, std::unique_ptr<Executor> run);

 private:
  const PlanFamily& family_;
  std::mutex mutex_;
  std::vector<std::vector<std::unique_ptr<Executor>>> idle_;  ///< unused executors of each member
};

}  // namespace stepwire::run
