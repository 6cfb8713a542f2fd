#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "engine/model/plan/compiled_plan.hpp"
#include "engine/simulate/run/both_sides.hpp"
#include "engine/simulate/run/discrete_phase.hpp"
#include "engine/simulate/run/event_stepper.hpp"
#include "engine/simulate/run/health.hpp"
#include "engine/simulate/run/loop_cost.hpp"
#include "engine/simulate/run/step_count.hpp"
#include "engine/simulate/run/stepper.hpp"
#include "engine/simulate/run/value_setter.hpp"

namespace stepwire::run {

/// All that moves in a run: copy it to keep a moment, put it back to return there.
struct Workspace {
  std::int64_t tick = 0;
  std::vector<double> values;
};

/// One run of a plan: its own copy of the blocks, bound to its own workspace. The plan must outlive it.
///
/// A tick is evaluate(), then, unless it is the last, advance(): outputs, then discrete updates, then the
/// solver. Neither allocates, throws, locks or calls the system.
class Executor {
 public:
  /// Throws Error where the diagram names a solver that is not known.
  explicit Executor(const plan::Plan& plan);
  Executor(const Executor&) = delete;
  Executor& operator=(const Executor&) = delete;

  /// From now on steps with compiled code, which must outlive this; call it between advance() and evaluate().
  /// Code that has other numbers than this run is not used, and none where both sides of instants are
  /// recorded.
  void use(const plan::CompiledPlan& code);
  bool compiled() const { return code_ != nullptr; }
  /// Adds what code must read from a table for the values that are set now.
  void widen(std::vector<plan::VariableBlock>& variable) const;
  /// What code reads of this run; nothing where code with such a table has other numbers than this run.
  std::optional<plan::NumberTable> numbers(const std::vector<plan::VariableBlock>& variable) const;
  /// Takes the place to which other code has stepped this run: after the outputs of a tick, or after its
  /// step.
  void stand_at(std::int64_t tick, std::span<const double> values, bool after_step);

  /// What set() came to.
  enum class Setting {
    done,
    structure_changed  ///< the values need another plan: sizes, rates or what is wired would be others
  };
  /// Sets values, one for each name of a variation of the plan's diagram, as ValueSetter::set(). Code that
  /// has one of the values as the plan has it is left, and the run is interpreted from then on. Allocates.
  [[nodiscard]] Setting set(const diagram::Variation& variation, std::span<const diagram::Assignment> values);
  /// The same for one parameter ("rig.mass"), value of a block ("spring.gain") or initial value, as `--set`
  /// reads it.
  [[nodiscard]] Setting set(const std::string& name, const std::string& value);
  /// The plan's diagram with the values that are set now, its blocks configured.
  diagram::Diagram diagram() const;
  /// Puts the values that are set now into a copy of the plan's diagram.
  void put_values(diagram::Diagram& diagram) const { setter_.put_values(diagram); }
  /// The present value of a parameter of the diagram, by its index in Diagram::parameters.
  const Value& parameter(std::size_t index) const { return setter_.parameter(index); }
  /// Why the last set() needs another plan.
  const std::string& structure_change() const { return setter_.structure_change(); }

  /// Puts everything at time 0.
  void reset();
  /// Computes all outputs at the present tick.
  void evaluate();
  /// Takes the run to the next tick: updates, then the solver. evaluate() comes first.
  void advance();
  /// Looks at the end of a run whether its steps were far too long, once its last tick is evaluated.
  void look_at_end();
  /// False after a value that is not finite, a step that the solver finds wrong or a diagnostic that ends the
  /// run.
  bool healthy() const { return health_.fine(); }
  /// True once `stop_when` has ended the run at an event, between two ticks, or a block has ended it that is
  /// no fault.
  bool has_stopped() const { return (events_ && events_->has_stopped()) || health_.has_ended(); }
  bool finished() const { return workspace_.tick >= plan_.steps; }
  std::int64_t tick() const { return workspace_.tick; }
  double time() const {
    return has_stopped() ? workspace_.values[plan::Layout::time] : plan_.time_of(workspace_.tick);
  }

  const plan::Plan& plan() const { return plan_; }
  const Workspace& workspace() const { return workspace_; }
  const double* values() const { return workspace_.values.data(); }
  /// Writes an input of the diagram, by its index in Diagram::inputs: as many numbers as it has elements.
  void write_input(std::size_t input, const double* numbers) { blocks_.write_input(input, numbers); }
  /// Who is told of a stretch of batches, from now on; null: nobody.
  void watch(ScheduleProbe* probe) { who_.probe = probe; }
  /// Shows both sides of instants from now on, in a plan that records them; to null, no longer.
  void show_sides(SideObserver* observer) {
    if (sides_) sides_->observer = observer;
  }
  /// Returns to a kept moment (as it was between advance() and evaluate()), with the values that are set now.
  void restore(const Workspace& workspace);

  /// From now on a loop that is not solved within its iterations ends no run, as a loop by the clock needs
  /// it.
  void go_on_unsolved() { health_.accept_unsolved(); }
  /// What the loops of the plan have cost up to now.
  std::vector<LoopCost> loop_costs() const { return run::loop_costs(plan_, values()); }
  /// How the solver has chosen its steps up to now, where it does.
  StepCount step_count() const { return run::step_count(plan_, values()); }
  /// Which events have been located up to now.
  EventCount event_count() const { return events_ ? events_->count() : EventCount{}; }

  /// Makes one call of the plan, which may be cut down to some of its blocks, at the present moment: for
  /// measuring what it costs.
  void call(const plan::KernelCall& batch) {
    batch.run(blocks_.memory() + batch.first, blocks_.memory() + batch.end);
  }
  /// Are all signals and continuous states finite? evaluate() asks this at every tick.
  bool is_finite() const { return health_.is_finite(); }

  /// What ended the run, once healthy() is false.
  std::optional<RunFault> fault() const { return health_.fault(time()); }
  std::vector<RaisedDiagnostic> diagnostics() const { return health_.diagnostics(); }

 private:
  /// Lets the code read a block that was set anew, or leaves the code that cannot.
  void read_numbers(std::size_t block);
  /// Writes again what follows from the values and not from the state.
  void follow_values();
  void find_outputs();
  void take_step();

  const plan::Plan& plan_;
  Workspace workspace_;
  BoundBlocks blocks_;
  Participants who_;
  CallTable once_;  ///< what does not change in a run
  DiscretePhase phase_;
  Stepper stepper_;
  std::optional<EventStepper> events_;  ///< where steps are split
  std::optional<BothSides> sides_;      ///< where both sides of instants are recorded
  ValueSetter setter_;
  Health health_;
  std::optional<CallTable> last_outputs_;     ///< outputs after the end that a block has set
  const plan::CompiledPlan* code_ = nullptr;  ///< none while interpreted
  std::optional<plan::NumberTable> numbers_;  ///< values that the code reads
};

}  // namespace stepwire::run
