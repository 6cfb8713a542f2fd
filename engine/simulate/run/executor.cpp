#include "engine/simulate/run/executor.hpp"

#include <algorithm>

#include "engine/simulate/run/event_stepper.hpp"
#include "engine/simulate/run/step_probe.hpp"
#include "engine/simulate/run/whole_step.hpp"

namespace stepwire::run {

namespace {

constexpr double never = 0.0;

}  // namespace

Executor::Executor(const plan::Plan& plan) : Executor(plan, fn::Selection(plan.diagram.uses_libm)) {}

Executor::Executor(const plan::Plan& plan, const fn::Selection&)
    : plan_(plan),
      workspace_{0, std::vector<double>(plan.layout.size, 0.0)},
      blocks_(plan, workspace_.values.data()),
      who_(blocks_),
      once_(plan.once, blocks_, who_),
      phase_(blocks_, who_),
      stepper_(blocks_, who_),
      left_(blocks_, who_, stepper_),
      setter_(blocks_),
      health_(blocks_),
      end_updates_(plan.end_updates, blocks_, who_) {
  if (plan.records_instants()) sides_.emplace(blocks_, who_, stepper_);
  if (plan.splits_steps())
    events_ =
        std::make_unique<EventStepper>(blocks_, who_, stepper_, left_, phase_, sides_ ? &*sides_ : nullptr);
  stopped_ = events_ ? events_->stopped() : &never;
  if (health_.may_end()) last_outputs_.emplace(plan.sides, blocks_, who_);
  reset();
}

Executor::~Executor() = default;

void Executor::use(const plan::CompiledPlan& code) {
  if (sides_ || (events_ && events_->observer)) return;
  numbers_.emplace(plan_, code.variable, [this](std::size_t block) { return blocks_.memory(block); });
  code_ = &code;
  for (const auto& [block, written] : setter_.written()) read_numbers(block);
}

void Executor::show_events(SideObserver* observer) {
  if (!events_) return;
  events_->observer = observer;
  if (observer) code_ = nullptr;
}

std::optional<plan::NumberTable> Executor::numbers(const std::vector<plan::VariableBlock>& variable) const {
  plan::NumberTable numbers(plan_, variable, [this](std::size_t block) { return blocks_.memory(block); });
  for (const auto& [block, written] : setter_.written())
    if (!numbers.read(block)) return std::nullopt;
  return numbers;
}

void Executor::read_numbers(std::size_t block) {
  if (code_ && !numbers_->read(block)) code_ = nullptr;
}

void Executor::widen(std::vector<plan::VariableBlock>& variable) const {
  stepwire::plan::widen(variable, plan_, [this](std::size_t block) { return blocks_.memory(block); });
}

void Executor::stand_at(std::int64_t tick, std::span<const double> values, bool after_step) {
  std::ranges::copy(values, workspace_.values.begin());
  workspace_.tick = after_step ? tick + 1 : tick;
  after_step ? health_.look_at_step() : health_.look_at_outputs();
}

Executor::Setting Executor::set(const std::string& name, const std::string& value) {
  const std::string place = "set " + name + "=" + value;
  return set(diagram::Variation(plan_.diagram, {name}),
             {{{name, diagram::value_of_text(value, place), place}}});
}

Executor::Setting Executor::set(const diagram::Variation& variation,
                                std::span<const diagram::Assignment> values) {
  const fn::Selection selection = functions();
  const auto rebuilt = setter_.set(variation, values);
  if (!rebuilt) return Setting::structure_changed;
  for (const std::size_t block : *rebuilt) read_numbers(block);
  follow_values();
  return Setting::done;
}

diagram::Diagram Executor::diagram() const {
  diagram::Diagram diagram = plan_.diagram;
  put_values(diagram);
  return diagram;
}

void Executor::reset() {
  const fn::Selection selection = functions();
  workspace_.tick = 0;
  health_.restart();
  blocks_.restart();
  once_.run_due();
  if (events_) events_->forget_end();
}

void Executor::restore(const Workspace& workspace) {
  // The blocks point into these numbers, so they are overwritten in place.
  std::ranges::copy(workspace.values, workspace_.values.begin());
  workspace_.tick = workspace.tick;
  health_.restart();
  follow_values();
}

void Executor::follow_values() {
  const fn::Selection selection = functions();
  blocks_.write_constants();
  once_.forget_loops();
  once_.run_due();
  workspace_.values[plan::Layout::timed] = plan::Layout::never;
  if (!events_) return;
  events_->forget_ahead();
  events_->forget_end();
}

EventCount Executor::event_count() const {
  return events_ ? events_->count() : EventCount{};
}

void Executor::evaluate() {
  if (has_stopped()) return;
  if (code_)
    code_->functions.evaluate(workspace_.values.data(), numbers_->data(), workspace_.tick);
  else
    find_outputs();
  health_.look_at_outputs();
}

void Executor::check_steps() {
  if (!healthy()) return;
  const fn::Selection selection = functions();
  find_unstable_steps(blocks_, stepper_, probe_memory_);
  health_.look_at_step();
}

void Executor::look_at_end() {
  if (!healthy()) return;
  if (!end_updates_.empty() && *stopped_ == 0.0) {
    const fn::Selection selection = functions();
    if (!health_.has_ended()) who_.find_due(workspace_.tick);
    end_updates_.run_due();
  }
  check_steps();
}

void Executor::find_outputs() {
  const fn::Selection selection = functions();
  workspace_.values[plan::Layout::time] = plan_.time_of(workspace_.tick);
  stepper_.follow_time();
  phase_.find_outputs(workspace_.tick, events_ && events_->is_ahead() && !who_.probe);
  if (events_) events_->forget_ahead();
}

void Executor::advance() {
  if (!has_stopped()) {
    if (code_)
      code_->functions.advance(workspace_.values.data(), numbers_->data(), workspace_.tick);
    else
      take_step();
    health_.look_at_step();
    if (sides_ && healthy() && !has_stopped()) {
      const fn::Selection selection = functions();
      const double end = plan_.time_of(workspace_.tick + 1);
      sides_->before(end, end);
    }
  }
  ++workspace_.tick;
}

void Executor::begin_step() {
  if (stepper_.moves()) who_.keep();
  if (plan_.updates_continuous) stepper_.find_outputs();
}

void Executor::find_slopes() {
  const fn::Selection selection = functions();
  phase_.update();
  begin_step();
  stepper_.find_slopes();
}

void Executor::take_step() {
  const fn::Selection selection = functions();
  if (events_) events_->keep_states();
  phase_.update();
  if (health_.has_ended()) return last_outputs_->run();
  begin_step();
  const double next = plan_.time_of(workspace_.tick + 1);
  if (const double end = health_.end(); end < next) return take_last_step(end);
  events_ ? events_->step(workspace_.tick) : stepper_.step(whole_step(plan_, workspace_.tick));
  if (!events_ || !events_->has_ended()) left_.update(next);
}

void Executor::take_last_step(double end) {
  if (events_)
    events_->step(workspace_.tick);
  else
    stepper_.step_to(workspace_.tick, end);
  if (!health_.has_ended()) return;
  last_outputs_->run();
  phase_.find_outputs(health_.tick_of_end(workspace_.tick), false);
}

}  // namespace stepwire::run
