#pragma once

#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "engine/model/diagram/load.hpp"
#include "engine/simulate/run/background_compilation.hpp"
#include "engine/simulate/run/executor.hpp"

namespace stepwire::run {

class PlanMember;
class MemberTrial;
class MemberTrials;

/// Set of plans of one file, for the values that a sweep, a study, a fit or a tuning sets.
///
/// Values that leave the structure unchanged share one plan; each other structure has its own. Thread-safe.
class PlanFamily {
 public:
  static constexpr std::size_t none = static_cast<std::size_t>(-1);  ///< no member
  using ValuesOfRun = std::function<std::vector<diagram::Setting>(std::size_t run)>;

  /// `base` is the plan of the file with `settings`. The loader must outlive the calls of find().
  PlanFamily(diagram::Loader& loader, std::string file, std::vector<diagram::Setting> settings,
             const plan::Plan& base);
  ~PlanFamily();

  /// Returns the index of the member whose plan fits these values, each of another name. Plans the file again
  /// if no member fits. Throws Error for refused values.
  std::size_t find(const std::vector<diagram::Setting>& values);
  /// Adds a member for runs that set values of these names, with the plan of the file at these values and the
  /// settings `fixed`. Throws Error.
  std::size_t add(const std::vector<diagram::Setting>& values, std::vector<diagram::Setting> fixed);
  /// Does the same with a plan made elsewhere. The values are not tried.
  std::size_t add(std::shared_ptr<const plan::Plan> plan, const std::vector<diagram::Setting>& values,
                  std::vector<diagram::Setting> fixed = {});
  /// Adds the differences of these values to those of a member's runs. Throws Error for refused values.
  void add_differences(std::size_t member, const std::vector<diagram::Setting>& values);
  /// Lets members whose blocks are alike have the same code, if their plans differ in values of these names.
  void share_code(const std::vector<std::string>& names);
  /// Finds the members of the first `runs` runs, with the values of `values_of`, on `threads` threads (0: all
  /// cores). The result is the same for any number of threads. Throws as find() does, for the first refused
  /// run, and names that run.
  std::vector<std::size_t> find_all(std::size_t runs, const ValuesOfRun& values_of, unsigned threads);

  /// Returns the file's diagram with the settings of a member and these values.
  diagram::Diagram load(std::size_t member, const std::vector<diagram::Setting>& values) const;
  /// Returns a new plan of the same, which is not added.
  std::shared_ptr<const plan::Plan> plan_anew(std::size_t member,
                                              const std::vector<diagram::Setting>& values) const;

  std::size_t size() const;
  const plan::Plan& plan(std::size_t member) const;
  /// Returns the values of blocks that a run of a member sets.
  const std::vector<diagram::Target>& targets(std::size_t member) const;
  /// Returns the differences between the runs of a member's plan, for the values that find() has seen.
  /// Members that set other names on the same plan share its code.
  std::vector<plan::VariableBlock> variable(std::size_t member) const;
  /// Returns the plans with the differences of their runs; `runs` is the number of runs of each, or empty.
  std::vector<PlanOfRuns> plans_of_runs(const std::vector<std::size_t>& runs = {}) const;
  /// Sets the values of a run and resets it to time 0. Returns false, with the run unchanged, if they need
  /// another plan. Throws Error for refused values.
  [[nodiscard]] bool set(std::size_t member, const std::vector<diagram::Setting>& values,
                         Executor& run) const;
  /// Does the same for values for which find() returned this member.
  void begin(std::size_t member, const std::vector<diagram::Setting>& values, Executor& run) const;

 private:
  std::vector<std::optional<std::size_t>> find_known(std::size_t first, std::size_t runs,
                                                     const ValuesOfRun& values_of, MemberTrials& trials,
                                                     unsigned threads);
  std::size_t find_named(const std::vector<diagram::Setting>& values);
  std::optional<std::size_t> known(const std::vector<diagram::Setting>& values, MemberTrial& trial) const;
  std::size_t add(std::unique_ptr<PlanMember> member);
  PlanMember& member(std::size_t index) const;
  diagram::Diagram loaded(const std::vector<diagram::Setting>& fixed,
                          const std::vector<diagram::Setting>& values) const;

  diagram::Loader& loader_;
  std::string file_;
  std::vector<diagram::Setting> settings_;
  std::shared_ptr<const plan::Plan> base_;
  bool is_swept_;
  mutable std::mutex finding_;  ///< serialises the loader, and find(), which alone adds members
  mutable std::mutex looking_;  ///< guards the list of members
  std::vector<std::unique_ptr<PlanMember>> members_;
  std::unique_ptr<MemberTrial> trial_;  ///< used by find()
};

}  // namespace stepwire::run
