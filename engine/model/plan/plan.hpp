#pragma once

#include <algorithm>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/base/math/tick_times.hpp"
#include "engine/model/diagram/diagram.hpp"

namespace stepwire::plan {

/// Rate at which a block runs.
struct Rate {
  enum class Kind { constant, discrete, continuous };
  Kind kind = Kind::constant;
  std::int64_t ticks = 1;  ///< period if discrete, else 1
  std::int64_t first = 0;  ///< tick of the first run, below the period

  bool operator==(const Rate&) const = default;
};

/// Ticks of calls: `first`, and each `ticks` after it.
struct Period {
  std::int64_t ticks = 1, first = 0;
  bool at_start = false;  ///< also at tick 0: outputs that are states exist from the start

  bool due(std::int64_t tick) const { return tick % ticks == first || (at_start && tick == 0); }
  bool operator==(const Period&) const = default;
};

/// One kernel call: blocks of one type that are contiguous in memory and run at the same ticks.
struct KernelCall {
  Kernel run;
  std::size_t first, end;  ///< byte offsets of the first block and past the last one in the memory of blocks
  std::size_t count;
  int period;  ///< index in Plan::periods
  std::ptrdiff_t active =
      -1;          ///< workspace index of the guard output that activates its blocks; -1: always active
  int guard = -1;  ///< index in Plan::guards of the guard that it runs; -1: none
  int late = -1;   ///< index in Plan::late of its single block; -1: none
};

/// Continuous states changed by a block's update and read by another update at the same instant. They take
/// their new values after all updates, so that each update reads the old ones.
struct LateStates {
  std::size_t block;                 ///< index in Plan::blocks
  std::size_t state, before, after;  ///< offsets in the workspace
  std::size_t size;
};

/// Location of a signal in the workspace, for recording and messages.
struct SignalSlot {
  std::size_t offset = 0;
  Eigen::Index size = 1;
  Eigen::Index columns = 1;  ///< of a matrix in column-major order

  Eigen::Index rows() const { return size / columns; }
};

/// A copy of numbers within the workspace.
struct Copied {
  std::size_t from, to, size;
};

/// Actions on changes of a guard (see engine/model/diagram/guard.hpp). While it is inactive, its blocks are
/// not called and their derivatives are 0.
struct PlannedGuard {
  std::size_t block = 0;
  std::size_t active = 0;      ///< Workspace index of its output.
  bool once_per_edge = false;  ///< It is active at single ticks, each of which is an activation of its own.
  std::vector<int> inside;     ///< Enclosed guards, as indices in Plan::guards.
  std::vector<Copied> keep;    ///< Outputs of stages, copied at a tick for readers while it is inactive.
  std::vector<SignalSlot> slopes;  ///< Derivatives of its states.
  std::vector<Copied> reset;       ///< Initial values of all states inside; empty if states are held.
  std::vector<std::size_t> start;  ///< Blocks inside with a start(), if states are reset.
};

/// An algebraic loop of outputs, torn so that its blocks can be called in sequence.
struct SolvedLoop {
  std::string path;  ///< its cycle as text, "error -> half -> twice -> error"
  std::vector<diagram::SignalRef> tears;
  std::vector<std::size_t> diagnostics;  ///< offsets in the workspace of its blocks' diagnostics
  std::size_t report = 0;                ///< offset of its solve::LoopReport in the workspace
  std::size_t residuals = 0;             ///< offset of the residuals of all tears
};

/// Calls of a table that are iterated until their loop is solved.
struct LoopCall {
  std::size_t first, end;  ///< range of calls in the table
  std::size_t loop;        ///< index in Plan::loops
  /// Torn signals that these calls compute; their slots hold the guesses.
  std::vector<SignalSlot> tears;
  std::vector<std::size_t> residuals;  ///< offset of the residuals of each of them
};

/// Crossing functions of one block.
struct CrossingCall {
  std::size_t block;  ///< index in Plan::blocks
  std::size_t first;  ///< index of its first crossing
  std::size_t count;
};

/// Layout of a run's workspace; offsets in doubles. Signals and continuous states are adjacent, so that one
/// pass over them finds non-finite numbers.
struct Layout {
  static constexpr std::size_t time = 0;
  static constexpr std::size_t timed = 1;  ///< time for which Plan::timed was last computed
  static constexpr std::size_t first = 2;  ///< offset of the first number of a block
  static constexpr std::size_t report_count = 10, loop_count = 7, event_count = 6;
  static constexpr double never = -1.0;  ///< value of `timed` before the start
  std::size_t signals = first;
  std::size_t states = first;
  std::size_t state_count = 0;
  std::size_t derivatives = first;
  std::size_t discrete = first;
  std::size_t discrete_count = 0;
  std::size_t diagnostics = first;
  std::size_t diagnostic_count = 0;
  std::size_t constants = first;
  std::size_t report = first;  ///< report of an implicit solver
  std::size_t loops = first;   ///< reports of loops
  std::size_t events = first;  ///< reports of located events, at the end
  std::size_t size = first;
};

/// A block as it runs.
struct PlannedBlock {
  std::size_t memory = 0;  ///< byte offset in the memory of blocks
  Rate rate;
  std::vector<SignalSlot> outputs;
  std::vector<SignalSlot> states;
  std::vector<SignalSlot> derivatives;  ///< parallel to states; unused for discrete ones
  std::vector<SignalSlot> diagnostics;
  std::vector<std::vector<SignalSlot>> inputs;
  std::vector<SignalSlot> initial;  ///< Initial values of states that a guard resets, else empty.
  std::vector<SignalSlot> kept;     ///< Outputs at the last tick, see PlannedGuard; else empty.
  std::vector<Eigen::Index> sizes;  ///< Parallel to BlockType::sizes.
  bool slope_is_input = false;      ///< Its input is stored as its derivative: no call of derivatives().
  std::optional<AnyBlock> written;  ///< The block as in its file, if configure() or prepare() change it.
  std::shared_ptr<const Configuration> configuration;  ///< Answers of configure(); nullptr without one.
};

/// Immutable execution plan of runs: the order of calls and the layout of memory.
struct Plan {
  diagram::Diagram diagram;
  std::int64_t steps = 0;  ///< number of ticks from 0 to stop
  TickTimes tick_times;    ///< of Diagram::step
  std::vector<PlannedBlock> blocks;
  std::vector<int> memory_order;  ///< indices of blocks in the order of their memory
  std::size_t block_bytes = 0;
  std::vector<Period> periods;  ///< of calls; the first one is each tick
  Layout layout;
  std::vector<double> constants;

  std::vector<KernelCall> once;     ///< constant outputs, computed at the start
  std::vector<KernelCall> timed;    ///< outputs that depend on time alone, computed when it changes
  std::vector<KernelCall> outputs;  ///< at every tick
  std::vector<KernelCall>
      stage;  ///< outputs that derivatives depend on, for the solver's stages between ticks
  std::vector<KernelCall> derivatives;
  std::vector<KernelCall> updates;
  std::vector<KernelCall> end_updates;  ///< those of them that are called at the last row, too
  std::vector<PlannedGuard> guards;     ///< each after the one that encloses it
  bool updates_continuous = false;      ///< an update may change a continuous state
  std::vector<LateStates> late;

  std::vector<SolvedLoop> loops;
  std::vector<LoopCall> once_loops, timed_loops, output_loops, stage_loops;  ///< of the tables above

  /// Returns the loops in one of the tables above.
  const std::vector<LoopCall>& loops_of(const std::vector<KernelCall>& table) const;

  /// True where a source may jump: the solver then must not evaluate the tick at the end of its step.
  bool jumps = false;
  /// True where steps are split at events.
  bool splits_steps() const { return crossing_count > 0 || !edges.empty(); }

  // Tables for located events; empty if events are not located.
  std::vector<std::size_t> edges;  ///< sources that declare their jumps or bends, as indices in Plan::blocks
  std::vector<CrossingCall> crossings;
  std::size_t crossing_count = 0;
  std::optional<std::size_t> stop_crossing;  ///< index of the crossing of `stop_when`
  /// Outputs for crossings that only the solver and time change, computed at the end of a step, and the
  /// remainder of `outputs`. Both are empty if there are no such outputs.
  std::vector<KernelCall> ahead, rest;
  std::vector<KernelCall> crossing_outputs;  ///< other outputs that crossings depend on between ticks
  std::vector<KernelCall> crossing_starts;   ///< outputs of both that no stage computes
  std::vector<KernelCall> event_outputs;     ///< outputs of blocks that act at every instant
  std::vector<KernelCall> event_befores;     ///< the same with the previous guards; empty if none is needed
  std::vector<KernelCall> event_updates;
  /// Outputs just before an instant, if both sides of it are recorded, and after one at which a block ends
  /// the run.
  std::vector<KernelCall> sides;
  std::vector<LoopCall> side_loops;
  /// Outputs for an external solver between instants: blocks with crossings keep their branch.
  std::vector<KernelCall> between;
  /// Updates of blocks that read their inputs just before each instant, and outputs that these inputs depend
  /// on.
  std::vector<KernelCall> left_updates, lefts;
  std::vector<LoopCall> left_loops;
  std::vector<LoopCall> ahead_loops, rest_loops, crossing_loops, crossing_start_loops, event_loops,
      event_before_loops;

  SignalSlot slot(const diagram::SignalRef& signal) const;
  std::optional<unit::Dimension> dimension(const diagram::SignalRef& signal) const;
  /// Returns the workspace offset of a variable of a stop condition.
  std::size_t offset(const diagram::SignalRef& variable) const {
    return variable.block < 0 ? Layout::time : slot(variable).offset;
  }
  /// True where both sides of each instant are recorded. Such a run is interpreted, and not in a lane batch.
  bool records_instants() const {
    return std::ranges::any_of(diagram.records, &diagram::RecordRequest::instants);
  }
  /// Returns the time of a tick [s].
  double time_of(std::int64_t tick) const { return tick_times(tick); }
};

/// Returns the number of steps in a time; std::nullopt if it is not whole. Decimal times are inexact in
/// binary, so a rounding difference is ignored.
std::optional<std::int64_t> whole_ticks(double time, double step);

/// Plans a checked diagram. Throws Error for faults that only planning finds: algebraic loops, incompatible
/// sizes, rates that do not fit the step, and parameters that blocks refuse.
Plan make_plan(diagram::Diagram diagram);

}  // namespace stepwire::plan
