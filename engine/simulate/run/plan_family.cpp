#include "engine/simulate/run/plan_family.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "engine/base/parallel/parallel.hpp"
#include "engine/simulate/run/plan_member.hpp"
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

}  // namespace

PlanFamily::PlanFamily(diagram::Loader& loader, std::string file, std::vector<diagram::Setting> settings,
                       const plan::Plan& base)
    : loader_(loader),
      file_(std::move(file)),
      settings_(std::move(settings)),
      base_(plan_of_runs(base)),
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
  return add(std::make_unique<PlanMember>(plan_anew(values), values));
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

std::shared_ptr<const plan::Plan> PlanFamily::plan_anew(const std::vector<diagram::Setting>& values) const {
  std::vector<diagram::Setting> all = settings_;
  all.insert(all.end(), values.begin(), values.end());
  auto made = std::make_shared<const plan::Plan>(plan::make_plan(loader_.load_point(file_, all)));
  require_same_columns(*made, *base_);
  return made;
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

void PlanFamily::begin(std::size_t member, const std::vector<diagram::Setting>& values, Executor& run) const {
  if (this->member(member).set(values, run) != Executor::Setting::done)
    throw std::logic_error("a run is given values of another structure: " + run.structure_change());
  run.reset();
}

std::unique_ptr<Executor> IdleRuns::take(std::size_t member) {
  {
    const std::lock_guard lock(mutex_);
    idle_.resize(family_.size());
    if (!idle_[member].empty()) {
      auto run = std::move(idle_[member].back());
      idle_[member].pop_back();
      return run;
    }
  }
  return std::make_unique<Executor>(family_.plan(member));
}

void IdleRuns::give_back(std::size_t member, std::unique_ptr<Executor> run) {
  const std::lock_guard lock(mutex_);
  idle_[member].push_back(std::move(run));
}

}  // namespace stepwire::run
