#include "engine/simulate/run/plan_member.hpp"

namespace stepwire::run {

namespace {

diagram::Assignment assignment_of(const diagram::Setting& setting) {
  diagram::Assignment assignment{setting.name, diagram::value_of_text(setting.value, setting.written),
                                 setting.written};
  assignment.value.mark = setting.mark;
  return assignment;
}

}  // namespace

std::vector<std::string> names_of(const std::vector<diagram::Setting>& values) {
  std::vector<std::string> names;
  for (const diagram::Setting& value : values) names.push_back(value.name);
  return names;
}

PlanMember::PlanMember(std::shared_ptr<const plan::Plan> of, const std::vector<diagram::Setting>& values)
    : plan_(std::move(of)),
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

}  // namespace stepwire::run
