#include "engine/stepwire/simulation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <span>
#include <stdexcept>
#include <utility>
#include <vector>

#include "engine/simulate/codegen/generated_code.hpp"
#include "engine/simulate/run/code_trial.hpp"
#include "engine/simulate/run/executor.hpp"
#include "engine/simulate/run/step_probe.hpp"
#include "engine/simulate/run/stop_condition.hpp"
#include "engine/stepwire/content.hpp"
#include "engine/stepwire/moment.hpp"

namespace stepwire {

/// Numbers for inputs, stored until the tick from which on they apply.
class WaitingInputs {
 public:
  explicit WaitingInputs(const std::vector<InputInfo>& inputs) {
    for (const InputInfo& input : inputs) waiting_.push_back({std::vector<double>(input.size), false});
  }
  void put(std::size_t input, std::span<const double> values) {
    std::ranges::copy(values, waiting_[input].values.begin());
    waiting_[input].fresh = true;
  }
  void write_to(run::Executor& run) {
    for (std::size_t i = 0; i < waiting_.size(); ++i)
      if (std::exchange(waiting_[i].fresh, false)) run.write_input(i, waiting_[i].values.data());
  }
  void drop() {
    for (Waiting& input : waiting_) input.fresh = false;
  }

 private:
  struct Waiting {
    std::vector<double> values;
    bool fresh;
  };
  std::vector<Waiting> waiting_;
};

void check_plan(const Snapshot& snapshot, const plan::Plan& plan) {
  if (snapshot.content().plan != &plan) throw std::logic_error("a snapshot of another model is restored");
}

struct Simulation::State {
  State(Model of, const SimulationOptions& options)
      : model(std::move(of)),
        run(plan()),
        stopper(plan()),
        inputs(model.inputs()),
        shown(plan().layout.size) {
    run.prepare_checks();
    find_next_check();
    const diagram::Variation tuned(plan().diagram, options.tuned);
    if (options.engine == run::ExecutionMode::interpreted) return;
    codegen::GeneratedCode source{run::code_trial()};
    code = source.compile(plan(), plan::variable_blocks(plan(), tuned), {});
    problem = source.take_problem();
    if (code) run.use(*code);
  }

  const plan::Plan& plan() const { return model.content().job->plan; }

  /// Advances from the present tick and keeps its numbers for later reads.
  void leave_tick() {
    if (!at_tick || ended) return;
    std::copy_n(run.values(), shown.size(), shown.begin());
    shown_tick = run.tick();
    at_tick = false;
    run.advance();
  }

  void step() {
    if (ended) throw yaml::Error(yaml::Fault{{model.file(), {}}, "", "the run has ended", {}});
    if (at_tick) run.advance();
    at_tick = true;
    require_health();
    inputs.write_to(run);
    run.evaluate();
    require_health();
    ended = run.finished() || run.has_stopped() || stopper.stops(run.values());
    if (!ended && run.tick() < next_check) return;
    ended ? run.look_at_end() : run.check_steps();
    find_next_check();
    require_health();
  }

  void find_next_check() { next_check = run::next_step_check(plan(), run.tick()); }

  void require_health() {
    if (run.healthy()) return;
    ended = true;
    if (auto fault = run.fault()) throw yaml::Error(std::move(fault->fault));
  }

  const double* values() const { return at_tick ? run.values() : shown.data(); }

  Model model;
  std::optional<plan::CompiledPlan> code;
  std::string problem;
  run::Executor run;
  run::StopConditionEvaluator stopper;
  WaitingInputs inputs;
  bool at_tick = false;  ///< true if outputs are computed and updates are not
  bool ended = false;
  std::int64_t next_check = 0;  ///< tick of run::next_step_check()
  std::vector<double> shown;    ///< numbers of the last tick
  std::int64_t shown_tick = 0;
};

Simulation::Simulation(Model model, const SimulationOptions& options)
    : state_(std::make_unique<State>(std::move(model), options)) {}
Simulation::~Simulation() = default;
Simulation::Simulation(Simulation&&) noexcept = default;
Simulation& Simulation::operator=(Simulation&&) noexcept = default;

void Simulation::set(const std::string& name, double value) {
  state_->leave_tick();
  set_value(state_->run, name, diagram::value_of_number(value, {}));
}

void Simulation::set(const std::string& name, const std::string& text) {
  yaml::Node value = diagram::value_of_text(text, "set " + name);
  state_->leave_tick();
  set_value(state_->run, name, std::move(value));
}

void Simulation::set(InputId input, double value) {
  set(input, std::span(&value, 1));
}

void Simulation::set(InputId input, std::span<const double> values) {
  const std::size_t index = state_->model.content().index(input);
  check_numbers(state_->model.inputs()[index], values);
  state_->inputs.put(index, values);
}

void Simulation::step() {
  state_->step();
}

bool Simulation::finished() const {
  return state_->ended;
}

double Simulation::time() const {
  return state_->at_tick ? state_->run.time() : state_->plan().time_of(state_->shown_tick);
}

std::span<const double> Simulation::operator[](SignalId signal) const {
  const Model::Content& content = state_->model.content();
  const plan::SignalSlot& slot = content.slots[content.index(signal)];
  return {state_->values() + slot.offset, static_cast<std::size_t>(slot.size)};
}

Snapshot Simulation::snapshot() {
  State& state = *state_;
  state.leave_tick();
  state.require_health();
  const double* shown = state.values();
  return Snapshot(std::make_shared<const Snapshot::Content>(
      Snapshot::Content{&state.plan(),
                        state.run.workspace(),
                        {shown, shown + state.shown.size()},
                        state.at_tick ? state.run.tick() : state.shown_tick,
                        state.ended}));
}

void Simulation::restore(const Snapshot& snapshot) {
  State& state = *state_;
  check_plan(snapshot, state.plan());
  const Snapshot::Content& moment = snapshot.content();
  state.run.restore(moment.workspace);
  state.find_next_check();
  state.shown = moment.shown;
  state.shown_tick = moment.shown_tick;
  state.ended = moment.ended;
  state.at_tick = false;
  state.inputs.drop();
}

void Simulation::reset() {
  state_->run.reset();
  state_->find_next_check();
  std::ranges::fill(state_->shown, 0.0);
  state_->shown_tick = 0;
  state_->at_tick = state_->ended = false;
  state_->inputs.drop();
}

bool Simulation::compiled() const {
  return state_->run.compiled();
}

const std::string& Simulation::compile_problem() const {
  return state_->problem;
}

const Model& Simulation::model() const {
  return state_->model;
}

}  // namespace stepwire
