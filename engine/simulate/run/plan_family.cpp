#include "engine/simulate/run/plan_family.hpp"

#include <algorithm>
#include <stdexcept>

namespace stepwire::run {

namespace {

constexpr std::size_t max_tried = 64;  // plans, of a sweep in which each point has another structure

std::vector<std::string> names_of(const std::vector<diagram::Setting>& values) {
  std::vector<std::string> names;
  for (const diagram::Setting& value : values) names.push_back(value.name);
  return names;
}

/// The plan of single runs, which need no sweep: it may have very many values.
std::shared_ptr<const plan::Plan> plan_of_runs(plan::Plan plan) {
  plan.diagram.sweep.reset();
  return std::make_shared<const plan::Plan>(std::move(plan));
}

diagram::Assignment assignment_of(const diagram::Setting& setting) {
  diagram::Assignment assignment{setting.name, diagram::value_of_text(setting.value, setting.written),
                                 setting.written};
  assignment.value.mark = setting.mark;
  return assignment;
}

}  // namespace

/// A plan, what its runs set, and what they share: the values that decide its structure.
struct PlanFamily::Member {
  Member(std::shared_ptr<const plan::Plan> of, const std::vector<diagram::Setting>& values)
      : plan(std::move(of)),
        names(names_of(values)),
        all(plan->diagram, names),
        free(plan->diagram, names_to_set()) {
    for (std::size_t i = 0; i < values.size(); ++i)
      structure.push_back(all.names()[i].structural ? values[i].value : "");
    variable = plan::variable_blocks(*plan, free);
  }

  /// May a run of this member have these values?
  bool may_take(const std::vector<diagram::Setting>& values) const {
    if (values.size() != names.size()) return false;
    for (std::size_t i = 0; i < values.size(); ++i)
      if (values[i].name != names[i] || (all.names()[i].structural && values[i].value != structure[i]))
        return false;
    return true;
  }

  Executor::Setting set(const std::vector<diagram::Setting>& values, Executor& run) const {
    std::vector<diagram::Assignment> assignments;
    for (std::size_t i = 0; i < values.size(); ++i)
      if (!all.names()[i].structural) assignments.push_back(assignment_of(values[i]));
    return run.set(free, assignments);
  }

  /// Makes a try of its own, for find().
  bool takes(const std::vector<diagram::Setting>& values) {
    if (!probe) probe = std::make_unique<Executor>(*plan);
    if (set(values, *probe) != Executor::Setting::done) return false;
    probe->widen(variable);
    return true;
  }

  std::vector<std::string> names_to_set() const {
    std::vector<std::string> result;
    for (const diagram::Variation::Name& name : all.names())
      if (!name.structural) result.push_back(name.text);
    return result;
  }

  std::shared_ptr<const plan::Plan> plan;
  std::vector<std::string> names;
  diagram::Variation all;                     ///< of all names
  diagram::Variation free;                    ///< of those that are set in a run of the plan
  std::vector<std::string> structure;         ///< values of structural names; "" of others
  std::vector<plan::VariableBlock> variable;  ///< so far
  std::unique_ptr<Executor> probe;
};

PlanFamily::PlanFamily(diagram::Loader& loader, std::string file, std::vector<diagram::Setting> settings,
                       const plan::Plan& base)
    : loader_(loader), file_(std::move(file)), settings_(std::move(settings)), base_(plan_of_runs(base)) {}

PlanFamily::~PlanFamily() = default;

std::size_t PlanFamily::find(const std::vector<diagram::Setting>& values) {
  const std::lock_guard lock(finding_);
  try {
    const std::size_t last = members_.size();
    for (std::size_t m = last; m-- > last - std::min(last, max_tried);)  // values come in order
      if (members_[m]->may_take(values) && members_[m]->takes(values)) return m;
    const bool known =
        std::ranges::any_of(members_, [&](const auto& member) { return member->names == names_of(values); });
    if (!known) {
      auto member = std::make_unique<Member>(base_, values);
      if (!member->all.structural() && member->takes(values)) return add(std::move(member));
    }
  } catch (const yaml::Error&) {  // planning the file with these values says the same, with all places
  }
  return add(std::make_unique<Member>(plan_anew(values), values));
}

std::size_t PlanFamily::add(std::unique_ptr<Member> member) {
  const std::lock_guard lock(looking_);
  members_.push_back(std::move(member));
  return members_.size() - 1;
}

PlanFamily::Member& PlanFamily::member(std::size_t index) const {
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
  return std::make_shared<const plan::Plan>(plan::make_plan(loader_.load_point(file_, all)));
}

const plan::Plan& PlanFamily::plan(std::size_t member) const {
  return *this->member(member).plan;
}

const std::vector<diagram::Target>& PlanFamily::targets(std::size_t member) const {
  return this->member(member).free.targets();
}

std::vector<plan::VariableBlock> PlanFamily::variable(std::size_t member) const {
  const auto& plan = this->member(member).plan;
  const std::lock_guard lock(finding_);  // what differs is widened there
  std::vector<plan::VariableBlock> variable;
  for (const auto& other : members_)
    if (other->plan == plan) plan::unite(variable, *plan, other->variable);
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
