#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "engine/model/plan/change.hpp"
#include "engine/model/plan/compiled_plan.hpp"
#include "engine/model/signal/input.hpp"
#include "engine/simulate/run/event_count.hpp"
#include "engine/simulate/run/guards.hpp"
#include "engine/simulate/run/loop_cost.hpp"
#include "engine/simulate/run/run_fault.hpp"
#include "engine/simulate/run/schedule_probe.hpp"
#include "engine/simulate/run/step_count.hpp"
#include "engine/simulate/run/stop_condition.hpp"
#include "engine/simulate/solve/event_locator.hpp"
#include "engine/simulate/solve/loop_solver.hpp"
#include "engine/simulate/solve/solver.hpp"

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
  ~Executor();
  Executor(const Executor&) = delete;
  Executor& operator=(const Executor&) = delete;

  /// From now on steps with compiled code, which must outlive this; call it between advance() and evaluate().
  /// Code that has other numbers than this run is not used.
  void use(const plan::CompiledPlan& code);
  bool compiled() const { return code_ != nullptr; }
  /// Adds what code must read from a table for the values that are set now.
  void widen(std::vector<plan::VariableBlock>& variable) const;

  /// What code reads of this run; nothing where code with such a table has other numbers than this run.
  std::optional<plan::NumberTable> numbers(const std::vector<plan::VariableBlock>& variable) const;
  /// Stands where other code has stepped this run to: after the outputs of a tick, or after its step.
  void stand_at(std::int64_t tick, std::span<const double> values, bool after_step);

  /// What set() came to.
  enum class Setting {
    done,
    structure_changed  ///< the values need another plan: sizes, rates or what is wired would be others
  };
  /// Sets values, one for each name of a variation of the plan's diagram, between two ticks: what follows
  /// from them is evaluated, configured and prepared as by a run that begins with these values. Where the
  /// structure changes, or where a value is refused (throws Error), everything stays as it was. Code that has
  /// one of the values as the plan has it is left, and the run goes on interpreted. Allocates.
  [[nodiscard]] Setting set(const diagram::Variation& variation, std::span<const diagram::Assignment> values);
  /// The same for one parameter ("rig.mass"), value of a block ("spring.gain") or initial value, as `--set`
  /// reads it.
  [[nodiscard]] Setting set(const std::string& name, const std::string& value);
  /// The plan's diagram with the values that are set now, its blocks configured.
  diagram::Diagram diagram() const;
  /// Puts the values that are set now into a copy of the plan's diagram.
  void put_values(diagram::Diagram& diagram) const;
  /// The present value of a parameter of the diagram, by its index in Diagram::parameters.
  const Value& parameter(std::size_t index) const;
  /// Why the last set() needs another plan.
  const std::string& structure_change() const { return structure_change_; }

  /// Puts everything at time 0.
  void reset();
  /// Computes all outputs at the present tick.
  void evaluate();
  /// Goes on to the next tick: updates, then the solver. evaluate() comes first.
  void advance();
  /// May the run go on? False after a value that is not finite, a step that the solver finds wrong or a
  /// diagnostic that ends the run.
  bool healthy() const { return healthy_; }
  /// Tells whether `stop_when` has ended the run at an event, between two ticks.
  bool has_stopped() const;
  bool finished() const { return workspace_.tick >= plan_.steps; }
  std::int64_t tick() const { return workspace_.tick; }
  double time() const {
    return has_stopped() ? workspace_.values[plan::Layout::time] : plan_.time_of(workspace_.tick);
  }

  const plan::Plan& plan() const { return plan_; }
  const Workspace& workspace() const { return workspace_; }
  const double* values() const { return workspace_.values.data(); }
  /// Writes an input of the diagram, by its index in Diagram::inputs: as many numbers as it has elements.
  void write_input(std::size_t input, const double* numbers);
  /// Who is told of a stretch of batches, from now on; null: nobody.
  void watch(ScheduleProbe* watcher) { watcher_ = watcher; }
  /// Returns to a kept moment (as it was between advance() and evaluate()), with the values that are set now.
  void restore(const Workspace& workspace);

  /// From now on the run goes on where a loop is not solved within its iterations, as a loop by the clock
  /// must.
  void go_on_unsolved() { goes_on_unsolved_ = true; }
  /// What the loops of the plan have cost up to now.
  std::vector<LoopCost> loop_costs() const;
  /// How the solver has chosen its steps up to now, where it does.
  StepCount step_count() const;
  /// Which events have been located up to now.
  EventCount event_count() const;

  /// Makes one call of the plan, which may be cut down to some of its blocks, at the present moment: for
  /// measuring what it costs.
  void call(const plan::KernelCall& batch) {
    batch.run(blocks_.get() + batch.first, blocks_.get() + batch.end);
  }
  /// Are all signals and continuous states finite? evaluate() asks this at every tick.
  bool is_finite() const;

  /// What ended the run, once healthy() is false.
  std::optional<RunFault> fault() const;
  std::vector<RaisedDiagnostic> diagnostics() const;

 private:
  class Equations;
  struct BetweenTicks;

  void apply(plan::PlanChange& change);
  void replace(plan::RebuiltBlock& rebuilt);
  void write_initial(const plan::SignalSlot& state, const Eigen::VectorXd& value);
  /// Lets the code read a block that was set anew, or leaves the code that cannot.
  void read_numbers(std::size_t block);
  void write_constants();
  /// Computes what does not change in a run.
  void compute_once();
  /// Writes again what follows from the values and not from the state.
  void follow_values();
  void bind();
  void bind_block(std::size_t block);
  void* memory(std::size_t block) const { return blocks_.get() + plan_.blocks[block].memory; }
  /// A table of calls of the plan, and where its blocks lie in this run.
  struct Table {
    struct Call {
      Kernel run;
      std::byte *first, *end;
    };
    /// Whether a call is made, in plans with guards.
    struct Gate {
      const double* active;  ///< 0 while it is not
      std::size_t next;      ///< the call to go on with then
    };
    /// Calls that are made until they agree.
    struct Loop {
      Loop(const plan::Plan& plan, const plan::LoopCall& call);

      std::size_t first, end, unknowns = 0;
      std::vector<solve::Tear> tears;
      solve::LoopTask task{};
      solve::LoopSolver<> solver;
    };
    Table(const plan::Plan& plan, const std::vector<plan::KernelCall>& batches, std::byte* blocks);
    void add_gates(const double* values);

    const std::vector<plan::KernelCall>& batches;
    std::vector<Call> calls;
    std::vector<Gate> gates;  ///< of each call; empty where the plan has no guard
    std::vector<Loop> loops;
  };

  /// The crossings of a block.
  struct CrossingLook {
    void (*run)(const void* block, double* numbers);
    const void* block;
    const double* active;  ///< 0 while it crosses nothing
    std::size_t first, count;
  };

  void run(Table& table);
  /// Computes what follows from the time alone, if it has changed.
  void follow_time();
  void run_due(Table& table);
  void run_watched(Table& table);
  /// Makes the calls of a part of a table that are due; a loop belongs to the part that has its first call.
  void run_range(Table& table, std::size_t first, std::size_t end);
  void run_calls(const Table& table, std::size_t first, std::size_t end);
  void solve_loop(const Table& table, Table::Loop& loop);
  bool loops_solved() const;
  std::optional<RunFault> unsolved_loop() const;
  void run_guarded(const Table& table, std::size_t first, std::size_t end);
  /// The solver's step, and the same from event to event where something has crossed.
  void take_located_step();
  void locate_events();
  /// When a source jumps or bends next [s].
  double next_edge() const;
  solve::EventTask event_task();
  void find_looks();
  void add_look(const plan::CrossingCall& call, const std::vector<bool>& stands);
  void look_for_crossings(double* numbers) const;
  static void look(const std::vector<CrossingLook>& looks, double* numbers);
  void look_at_start();
  std::vector<bool> standing_numbers() const;
  /// Computes what crossings depend on.
  void follow_crossings();
  bool is_ahead() const;
  void forget_ahead();
  std::optional<RunFault> event_fault() const;
  void find_due();
  void take_step();
  void step_states(const solve::TimeStep& step);
  /// Those that the last step has moved.
  const std::vector<solve::StatePiece>& moving_states() const;
  /// Looks whether the run may go on after outputs, and after a step.
  void look_at_outputs() { healthy_ = healthy_ && is_finite() && loops_solved(); }
  void look_at_step();
  bool diagnostic_ends_run() const;
  std::optional<RunFault> wrong_step() const;
  std::optional<RunFault> not_finite() const;
  std::string diagnostic_text(std::size_t block, std::size_t diagnostic) const;

  struct FreeBlocks {
    void operator()(std::byte* memory) const;
  };

  const plan::Plan& plan_;
  std::unique_ptr<solve::Solver> solver_;  ///< none where nothing is continuous
  Workspace workspace_;
  std::vector<double> constants_;
  std::vector<std::pair<plan::SignalSlot, Eigen::VectorXd>>
      initial_;                                  ///< values that were set, in the place of the plan's
  std::vector<Inputs::Element> list_elements_;   ///< of all list inputs, in the order of blocks in memory
  std::vector<std::size_t> first_list_element_;  ///< of each block
  std::unique_ptr<std::byte, FreeBlocks> blocks_;
  Table once_, timed_, outputs_, stage_, derivatives_, updates_;
  Table ahead_, rest_, crossing_outputs_, crossing_starts_, event_befores_, event_outputs_, event_updates_;
  std::optional<StopMargin> stop_margin_;  ///< where `stop_when` is located
  /// Those that only solver and time change are as they were at the end of the step before, unless something
  /// else has changed the states.
  std::vector<CrossingLook> looks_, changing_looks_;
  /// A source that declares its edges.
  struct Edge {
    double (*next)(const void* block);
    const void* block;
  };
  std::vector<Edge> edges_;
  bool stop_changes_ = false;  ///< is the number of `stop_when` one of these?
  /// The numbers of crossings at the start and at the end of a step, and the states at that of the last one.
  std::vector<double> before_, after_, end_states_;
  bool states_change_ = false;  ///< may anything but the solver change states?
  bool knows_end_ = false;      ///< are they those of the last step?
  std::vector<double> event_scratch_;
  std::unique_ptr<Equations> equations_;
  std::optional<Guards> guards_;  ///< none where the plan has none
  /// A stretch of the workspace.
  struct Piece {
    std::size_t first, end;
    const double* active;  ///< 0 while nothing in it moves; null: it always may
  };
  std::vector<Piece> pieces_of(std::size_t first, std::size_t end) const;
  std::vector<Piece> checked_, states_;  ///< what has to be finite, and the continuous states
  std::vector<char> due_;                ///< for each of the plan's periods
  std::vector<std::size_t> ending_diagnostics_;
  ScheduleProbe* watcher_ = nullptr;
  bool healthy_ = true, goes_on_unsolved_ = false;
  const plan::CompiledPlan* code_ = nullptr;           ///< none while interpreted
  std::optional<plan::NumberTable> numbers_;           ///< that the code reads
  std::optional<diagram::ParameterState> parameters_;  ///< once one is set
  plan::WrittenBlocks written_;                        ///< of which values were set
  std::string structure_change_;
};

}  // namespace stepwire::run
