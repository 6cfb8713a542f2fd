#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "engine/base/math/elementary.hpp"
#include "engine/model/plan/compiled_plan.hpp"
#include "engine/simulate/run/both_sides.hpp"
#include "engine/simulate/run/discrete_phase.hpp"
#include "engine/simulate/run/event_count.hpp"
#include "engine/simulate/run/health.hpp"
#include "engine/simulate/run/left_side.hpp"
#include "engine/simulate/run/loop_cost.hpp"
#include "engine/simulate/run/step_count.hpp"
#include "engine/simulate/run/step_probe.hpp"
#include "engine/simulate/run/stepper.hpp"
#include "engine/simulate/run/value_setter.hpp"

namespace stepwire::run {

class EventStepper;

/// Complete mutable state of a run. A copy is a snapshot; Executor::restore() loads it.
struct Workspace {
  std::int64_t tick = 0;
  std::vector<double> values;
};

/// One run of a plan: its own copies of the blocks, bound to its own workspace. The plan must outlive it.
///
/// A tick is evaluate() and, unless it is the last one, advance(): outputs, then discrete updates, then the
/// solver. Neither allocates, throws, locks or makes a system call.
class Executor {
 public:
  /// Throws Error if the diagram names an unknown solver.
  explicit Executor(const plan::Plan& plan);
  ~Executor();
  Executor(const Executor&) = delete;
  Executor& operator=(const Executor&) = delete;

  /// Switches to compiled code, which must outlive this object. Call it between advance() and evaluate(). Has
  /// no effect if the code was compiled for other numbers than this run's, or while both sides of instants
  /// are recorded or events are observed.
  void use(const plan::CompiledPlan& code);
  bool compiled() const { return code_ != nullptr; }
  /// Extends `variable` by the members that code must read from a table for the present values.
  void widen(std::vector<plan::VariableBlock>& variable) const;
  /// Returns the table that compiled code reads of this run. Returns std::nullopt if code with such a table
  /// was compiled for other numbers than this run's.
  std::optional<plan::NumberTable> numbers(const std::vector<plan::VariableBlock>& variable) const;
  /// Loads the state to which other code has stepped this run: after the outputs of a tick, or after its
  /// step.
  void stand_at(std::int64_t tick, std::span<const double> values, bool after_step);

  /// Outcome of set().
  enum class Setting {
    done,
    structure_changed  ///< the values change sizes, rates or wires and need another plan
  };
  /// Sets one value for each name of a variation of the plan's diagram, as ValueSetter::set() does. If the
  /// code has one of the values as a constant, the run is interpreted from then on. Allocates.
  [[nodiscard]] Setting set(const diagram::Variation& variation, std::span<const diagram::Assignment> values);
  /// Sets one parameter ("rig.mass"), value of a block ("spring.gain") or initial value, with the text of
  /// `--set`.
  [[nodiscard]] Setting set(const std::string& name, const std::string& value);
  /// Returns the plan's diagram with the present values, its blocks configured.
  diagram::Diagram diagram() const;
  /// Writes the present values into a copy of the plan's diagram.
  void put_values(diagram::Diagram& diagram) const { setter_.put_values(diagram); }
  /// Returns the present value of a parameter, by its index in Diagram::parameters.
  const Value& parameter(std::size_t index) const { return setter_.parameter(index); }
  /// Returns the reason why the last set() needs another plan.
  const std::string& structure_change() const { return setter_.structure_change(); }

  /// Sets the run to time 0.
  void reset();
  /// Computes all outputs at the present tick.
  void evaluate();
  /// Steps the run to the next tick: updates, then the solver. Call evaluate() before.
  void advance();
  /// Computes the derivatives of the states at the present tick, after its updates, in place of a step. Call
  /// evaluate() before. Interpreted only.
  void find_slopes();
  /// Checks whether the steps of the solver are unstable. Call it after evaluate() of the ticks of
  /// next_step_check().
  void check_steps();
  /// Checks the steps, and what blocks assert at the last row. Call it after evaluate() of the last tick.
  void look_at_end();
  /// Reserves the memory of check_steps(), which then allocates only for steps in doubt.
  void prepare_checks() { probe_memory_.prepare(plan_); }
  /// False after a non-finite value, a failed step or a diagnostic that ends the run.
  bool healthy() const { return health_.fine(); }
  /// True once the run has ended at an event between two ticks, by `stop_when` or as a fault.
  bool has_stopped_between() const { return *stopped_ != 0.0; }
  /// The same, and where a block has ended the run without a fault.
  bool has_stopped() const { return *stopped_ != 0.0 || (health_.may_end() && health_.has_ended()); }
  bool finished() const { return workspace_.tick >= plan_.steps; }
  std::int64_t tick() const { return workspace_.tick; }
  double time() const {
    return has_stopped() ? workspace_.values[plan::Layout::time] : plan_.time_of(workspace_.tick);
  }

  const plan::Plan& plan() const { return plan_; }
  const Workspace& workspace() const { return workspace_; }
  const double* values() const { return workspace_.values.data(); }
  /// Writes an input of the diagram, by its index in Diagram::inputs. `numbers` has one number for each
  /// element.
  void write_input(std::size_t input, const double* numbers) { blocks_.write_input(input, numbers); }
  /// Sets the schedule probe; nullptr removes it.
  void watch(ScheduleProbe* probe) { who_.probe = probe; }
  /// Sets the observer of both sides of instants, in a plan that records them; nullptr removes it.
  void show_sides(SideObserver* observer) {
    if (sides_) sides_->observer = observer;
  }
  /// Sets the observer of located events; nullptr removes it. The run is interpreted meanwhile.
  void show_events(SideObserver* observer);
  /// Loads a snapshot that was taken between advance() and evaluate(). The present parameter values stay.
  void restore(const Workspace& workspace);

  /// Disables the fault of an algebraic loop that does not converge, as real-time runs need it.
  void go_on_unsolved() { health_.accept_unsolved(); }
  /// Returns the cost of the algebraic loops up to now.
  std::vector<LoopCost> loop_costs() const { return run::loop_costs(plan_, values()); }
  /// Returns the counts of accepted and rejected steps up to now, for solvers with error control.
  StepCount step_count() const { return run::step_count(plan_, values()); }
  /// Returns the counts of located events up to now.
  EventCount event_count() const;

  /// Runs one call of the plan, or a part of its blocks, at the present instant. Used to measure its cost.
  void call(const plan::KernelCall& batch) {
    const fn::Selection selection = functions();
    batch.run(blocks_.memory() + batch.first, blocks_.memory() + batch.end);
  }
  /// True if all signals and continuous states are finite. evaluate() checks it at every tick.
  bool is_finite() const { return health_.is_finite(); }

  /// Returns the fault that ended the run, once healthy() is false.
  std::optional<RunFault> fault() const { return health_.fault(time()); }
  std::vector<RaisedDiagnostic> diagnostics() const { return health_.diagnostics(); }

 private:
  /// Makes a run while the functions of its plan are selected.
  Executor(const plan::Plan& plan, const fn::Selection& selected);

  /// Selects the elementary functions of the plan. Each public function that may call blocks does so first.
  fn::Selection functions() const { return fn::Selection(plan_.diagram.uses_libm); }
  /// Updates the code's number table for a block that was set, or leaves code that has its old values as
  /// constants.
  void read_numbers(std::size_t block);
  /// Recomputes the numbers that depend on parameter values and not on the state.
  void follow_values();
  void find_outputs();
  void begin_step();
  void take_step();
  /// Steps to the time within the present step at which a block ends the run.
  void take_last_step(double end);

  const plan::Plan& plan_;
  Workspace workspace_;
  BoundBlocks blocks_;
  Participants who_;
  CallTable once_;  ///< calls whose results are constant in a run
  DiscretePhase phase_;
  Stepper stepper_;
  LeftSide left_;
  StepProbeMemory probe_memory_;
  std::unique_ptr<EventStepper> events_;  ///< present if steps are split at events
  const double* stopped_;                 ///< address of a number that is not 0 after an end at an event
  std::optional<BothSides> sides_;        ///< present if both sides of instants are recorded
  ValueSetter setter_;
  Health health_;
  CallTable end_updates_;
  std::optional<CallTable> last_outputs_;     ///< Outputs after a block has ended the run.
  const plan::CompiledPlan* code_ = nullptr;  ///< nullptr while interpreted
  std::optional<plan::NumberTable> numbers_;  ///< Numbers that the code reads.
};

}  // namespace stepwire::run
