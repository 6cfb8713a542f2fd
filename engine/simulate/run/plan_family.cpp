#include "engine/simulate/run/plan_family.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <unordered_map>
#include <utility>

#include "engine/base/parallel/parallel.hpp"
#include "engine/model/diagram/variation.hpp"
#include "engine/simulate/run/sweep_ends.hpp"

namespace stepwire::run {

namespace {

constexpr std::size_t max_tried = 64;  // members, if all points differ in structure
constexpr std::size_t at_once = 64;    // runs of one piece of work of a thread

/// Returns the plan for single runs, without the sweep, whose list of values may be very long.
std::shared_ptr<const plan::Plan> plan_of_runs(plan::Plan plan) {
  plan.diagram.sweep.reset();
  return std::make_shared<const plan::Plan>(std::move(plan));
}

/// Returns the names that a diagram has: a part of the file's diagram does not have the values of all blocks.
std::vector<std::string> known_names(const diagram::Diagram& diagram, std::vector<std::string> names) {
  std::erase_if(names, [&](const std::string& name) {
    try {
      diagram::Variation(diagram, {name});
      return false;
    } catch (const yaml::Error&) {
      return true;
    }
  });
  return names;
}

/// True if the plans of two members can share code that reads these blocks from a table.
bool are_alike(const std::vector<plan::VariableBlock>& variable, const plan::Plan& one,
               const plan::Plan& other) {
  if (one.blocks.size() != other.blocks.size()) return false;
  return std::ranges::all_of(variable, [&](const plan::VariableBlock& of) {
    const AnyBlock &a = one.diagram.blocks[of.block].block, &b = other.diagram.blocks[of.block].block;
    return &a.type() == &b.type() &&
           plan::MemberItems(a.type(), a.get()).outline() == plan::MemberItems(b.type(), b.get()).outline();
  });
}

/// Throws Error if a recorded signal has other elements than in the base plan, since all runs share a table.
void require_same_columns(const plan::Plan& plan, const plan::Plan& base) {
  for (std::size_t r = 0; r < plan.diagram.records.size(); ++r)
    for (std::size_t s = 0; s < plan.diagram.records[r].signals.size(); ++s) {
      const diagram::RecordedSignal& signal = plan.diagram.records[r].signals[s];
      const plan::SignalSlot slot = plan.slot(signal.signal);
      const plan::SignalSlot expected = base.slot(base.diagram.records[r].signals[s].signal);
      if (slot.size == expected.size && slot.columns == expected.columns) continue;
      throw yaml::Error(plan.diagram.fault(
          signal.origin, signal.name,
          fmt::format(
              "it has {} elements and not {} as with the values of the file; take it out of `record`, "
              "or out of the sweep what changes its size",
              slot.size, expected.size)));
    }
}

diagram::Assignment assignment_of(const diagram::Setting& setting) {
  diagram::Assignment assignment{setting.name, diagram::value_of_text(setting.value, setting.written),
                                 setting.written};
  assignment.value.mark = setting.mark;
  return assignment;
}

std::vector<std::string> names_of(const std::vector<diagram::Setting>& values) {
  std::vector<std::string> names;
  for (const diagram::Setting& value : values) names.push_back(value.name);
  return names;
}

}  // namespace

/// Plan of a family, the names that its runs set, and the values that its runs share because they decide the
/// structure.
class PlanMember {
 public:
  /// `values` are those of one run; `fixed` are the settings of the plan that its runs do not set.
  PlanMember(std::shared_ptr<const plan::Plan> of, const std::vector<diagram::Setting>& values,
             std::vector<diagram::Setting> fixed = {});

  /// True if these values have this member's names and structural values. They may still be refused when set.
  bool may_take(const std::vector<diagram::Setting>& values) const;
  /// Sets the values in a run of the plan.
  Executor::Setting set(const std::vector<diagram::Setting>& values, Executor& run) const;
  /// True if one of its names decides the structure.
  bool is_structural() const { return all_.structural(); }

  const std::shared_ptr<const plan::Plan>& plan() const { return plan_; }
  const std::vector<std::string>& names() const { return names_; }
  const std::vector<diagram::Setting>& fixed() const { return fixed_; }
  /// Returns the values of blocks that a run sets.
  const std::vector<diagram::Target>& targets() const { return free_.targets(); }
  /// Returns the differences between the runs so far.
  const std::vector<plan::VariableBlock>& variable() const { return variable_; }
  void widen(const std::vector<plan::VariableBlock>& more);

 private:
  std::vector<std::string> names_to_set() const;

  std::shared_ptr<const plan::Plan> plan_;
  std::vector<diagram::Setting> fixed_;
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

PlanMember::PlanMember(std::shared_ptr<const plan::Plan> of, const std::vector<diagram::Setting>& values,
                       std::vector<diagram::Setting> fixed)
    : plan_(std::move(of)),
      fixed_(std::move(fixed)),
      names_(names_of(values)),
      all_(plan_->diagram, names_),
      free_(plan_->diagram, names_to_set()) {
  for (std::size_t i = 0; i < values.size(); ++i)
    structure_.push_back(all_.names()[i].structural ? values[i].value : "");
  variable_ = plan::variable_blocks(*plan_, free_);
}

bool PlanMember::may_take(const std::vector<diagram::Setting>& values) const {
  if (values.size() != names_.size()) return false;
  for (std::size_t i = 0; i < values.size(); ++i)
    if (values[i].name != names_[i] || (all_.names()[i].structural && values[i].value != structure_[i]))
      return false;
  return true;
}

Executor::Setting PlanMember::set(const std::vector<diagram::Setting>& values, Executor& run) const {
  std::vector<diagram::Assignment> assignments;
  for (std::size_t i = 0; i < values.size(); ++i)
    if (!all_.names()[i].structural) assignments.push_back(assignment_of(values[i]));
  return run.set(free_, assignments);
}

void PlanMember::widen(const std::vector<plan::VariableBlock>& more) {
  plan::unite(variable_, *plan_, more);
}

std::vector<std::string> PlanMember::names_to_set() const {
  std::vector<std::string> result;
  for (const diagram::Variation::Name& name : all_.names())
    if (!name.structural) result.push_back(name.text);
  return result;
}

bool MemberTrial::takes(const PlanMember& member, const std::vector<diagram::Setting>& values) {
  Tried& tried = tried_[&member];
  if (!tried.run) tried = {std::make_unique<Executor>(*member.plan()), member.variable()};
  if (member.set(values, *tried.run) != Executor::Setting::done) return false;
  tried.run->widen(tried.variable);
  return true;
}

void MemberTrial::add_to(PlanMember& member) const {
  if (const auto tried = tried_.find(&member); tried != tried_.end()) member.widen(tried->second.variable);
}

std::unique_ptr<MemberTrial> MemberTrials::take() {
  const std::lock_guard lock(mutex_);
  if (idle_.empty()) return std::make_unique<MemberTrial>();
  auto trial = std::move(idle_.back());
  idle_.pop_back();
  return trial;
}

PlanFamily::PlanFamily(diagram::Loader& loader, std::string file, std::vector<diagram::Setting> settings,
                       const plan::Plan& base)
    : loader_(loader),
      file_(std::move(file)),
      settings_(std::move(settings)),
      base_(plan_of_runs(base)),
      is_swept_(base.diagram.sweep.has_value()),
      trial_(std::make_unique<MemberTrial>()) {}

PlanFamily::~PlanFamily() = default;

std::size_t PlanFamily::find(const std::vector<diagram::Setting>& values) {
  const std::lock_guard lock(finding_);
  try {
    if (const auto member = known(values, *trial_)) {
      trial_->add_to(*members_[*member]);
      return *member;
    }
    const bool has_names = std::ranges::any_of(
        members_, [&](const auto& member) { return member->names() == names_of(values); });
    if (!has_names) {
      auto member = std::make_unique<PlanMember>(base_, values);
      MemberTrial first;
      if (!member->is_structural() && first.takes(*member, values)) {
        first.add_to(*member);
        return add(std::move(member));
      }
    }
  } catch (const yaml::Error&) {  // planning the file reports the same fault, with all places
  }
  auto plan = std::make_shared<const plan::Plan>(plan::make_plan(loaded({}, values)));
  require_same_columns(*plan, *base_);
  return add(std::make_unique<PlanMember>(std::move(plan), values));
}

std::size_t PlanFamily::add(const std::vector<diagram::Setting>& values,
                            std::vector<diagram::Setting> fixed) {
  const std::lock_guard lock(finding_);
  auto plan = std::make_shared<const plan::Plan>(plan::make_plan(loaded(fixed, values)));
  return add(std::make_unique<PlanMember>(std::move(plan), values, std::move(fixed)));
}

std::size_t PlanFamily::add(std::shared_ptr<const plan::Plan> plan,
                            const std::vector<diagram::Setting>& values,
                            std::vector<diagram::Setting> fixed) {
  const std::lock_guard lock(finding_);
  return add(std::make_unique<PlanMember>(std::move(plan), values, std::move(fixed)));
}

void PlanFamily::add_differences(std::size_t member, const std::vector<diagram::Setting>& values) {
  const std::lock_guard lock(finding_);
  if (trial_->takes(*members_[member], values)) trial_->add_to(*members_[member]);
}

void PlanFamily::share_code(const std::vector<std::string>& names) {
  const std::lock_guard lock(finding_);
  for (const auto& member : members_) {
    const diagram::Diagram& diagram = member->plan()->diagram;
    member->widen(
        plan::variable_blocks(*member->plan(), diagram::Variation(diagram, known_names(diagram, names))));
  }
  const plan::Plan& first = *members_.front()->plan();
  std::vector<plan::VariableBlock> shared = members_.front()->variable();
  std::vector<PlanMember*> alike;
  for (const auto& member : members_)
    if (are_alike(shared, first, *member->plan())) alike.push_back(member.get());
  for (const PlanMember* member : alike)
    plan::widen(shared, first, [&](std::size_t b) { return member->plan()->diagram.blocks[b].block.get(); });
  for (PlanMember* member : alike) member->widen(shared);
}

/// Returns the member that fits, without a lock of the list of members: the caller holds `finding_`, and only
/// its holder adds members.
std::optional<std::size_t> PlanFamily::known(const std::vector<diagram::Setting>& values,
                                             MemberTrial& trial) const {
  const std::size_t last = members_.size();
  for (std::size_t m = last; m-- > last - std::min(last, max_tried);)  // similar ones are last
    if (members_[m]->may_take(values) && trial.takes(*members_[m], values)) return m;
  return std::nullopt;
}

std::vector<std::size_t> PlanFamily::find_all(std::size_t runs, const ValuesOfRun& values_of,
                                              unsigned threads) {
  std::vector<std::size_t> members;
  MemberTrials trials;
  while (members.size() < runs) {
    const std::size_t first = members.size(), more = std::min(runs - first, std::max(first, at_once));
    for (const std::optional<std::size_t> member : find_known(first, more, values_of, trials, threads))
      members.push_back(member ? *member : find_named(values_of(members.size())));
  }
  return members;
}

/// Finds existing members for the runs [first, first + runs); std::nullopt for a run that none of them fits.
std::vector<std::optional<std::size_t>> PlanFamily::find_known(std::size_t first, std::size_t runs,
                                                               const ValuesOfRun& values_of,
                                                               MemberTrials& trials, unsigned threads) {
  const std::lock_guard lock(finding_);
  std::vector<std::optional<std::size_t>> found(runs);
  if (members_.empty()) return found;
  parallel::in_parallel((runs + at_once - 1) / at_once, threads, [&](std::size_t part) {
    trials.use([&](MemberTrial& trial) {
      for (std::size_t run = part * at_once; run < std::min(runs, (part + 1) * at_once); ++run) try {
          found[run] = known(values_of(first + run), trial);
        } catch (const yaml::Error&) {  // find() throws it later, in the order of the runs
        }
    });
  });
  for (const auto& trial : trials.all())
    for (const auto& member : members_) trial->add_to(*member);
  return found;
}

std::size_t PlanFamily::find_named(const std::vector<diagram::Setting>& values) {
  try {
    return find(values);
  } catch (const yaml::Error& error) {
    std::vector<yaml::Fault> faults = error.faults();
    for (yaml::Fault& fault : faults) fault.message += which_run(values);
    throw yaml::Error(std::move(faults));
  }
}

std::size_t PlanFamily::add(std::unique_ptr<PlanMember> member) {
  const std::lock_guard lock(looking_);
  members_.push_back(std::move(member));
  return members_.size() - 1;
}

PlanMember& PlanFamily::member(std::size_t index) const {
  const std::lock_guard lock(looking_);
  return *members_[index];
}

std::size_t PlanFamily::size() const {
  const std::lock_guard lock(looking_);
  return members_.size();
}

diagram::Diagram PlanFamily::loaded(const std::vector<diagram::Setting>& fixed,
                                    const std::vector<diagram::Setting>& values) const {
  std::vector<diagram::Setting> all = settings_;
  all.insert(all.end(), fixed.begin(), fixed.end());
  all.insert(all.end(), values.begin(), values.end());
  return loader_.load_point(file_, all);
}

diagram::Diagram PlanFamily::load(std::size_t member, const std::vector<diagram::Setting>& values) const {
  const std::lock_guard lock(finding_);
  return loaded(members_[member]->fixed(), values);
}

std::shared_ptr<const plan::Plan> PlanFamily::plan_anew(std::size_t member,
                                                        const std::vector<diagram::Setting>& values) const {
  auto plan = std::make_shared<const plan::Plan>(plan::make_plan(load(member, values)));
  if (is_swept_) require_same_columns(*plan, *base_);
  return plan;
}

const plan::Plan& PlanFamily::plan(std::size_t member) const {
  return *this->member(member).plan();
}

const std::vector<diagram::Target>& PlanFamily::targets(std::size_t member) const {
  return this->member(member).targets();
}

std::vector<plan::VariableBlock> PlanFamily::variable(std::size_t member) const {
  const auto& plan = this->member(member).plan();
  const std::lock_guard lock(finding_);  // find() extends the differences under this lock
  std::vector<plan::VariableBlock> variable;
  for (const auto& other : members_)
    if (other->plan() == plan) plan::unite(variable, *plan, other->variable());
  return variable;
}

std::vector<PlanOfRuns> PlanFamily::plans_of_runs(const std::vector<std::size_t>& runs) const {
  std::vector<PlanOfRuns> plans;
  for (std::size_t m = 0; m < size(); ++m) {
    plans.push_back({&plan(m), {variable(m), targets(m)}});
    if (!runs.empty()) plans.back().runs = runs[m];
  }
  return plans;
}

bool PlanFamily::set(std::size_t member, const std::vector<diagram::Setting>& values, Executor& run) const {
  const PlanMember& of = this->member(member);
  if (!of.may_take(values) || of.set(values, run) != Executor::Setting::done) return false;
  run.reset();
  return true;
}

void PlanFamily::begin(std::size_t member, const std::vector<diagram::Setting>& values, Executor& run) const {
  if (!set(member, values, run))
    throw std::logic_error("a run is given values of another structure: " + run.structure_change());
}

}  // namespace stepwire::run
