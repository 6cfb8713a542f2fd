#pragma once

#include <algorithm>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/model/diagram/diagram.hpp"

namespace stepwire::plan {

/// When a block runs.
struct Rate {
  enum class Kind { constant, discrete, continuous };
  Kind kind = Kind::constant;
  std::int64_t ticks = 1;  ///< period, for discrete; 1 for continuous
  std::int64_t first = 0;  ///< tick of the first run, below the period

  bool operator==(const Rate&) const = default;
};

/// The ticks at which calls are made: `first`, and each `ticks` after it.
struct Period {
  std::int64_t ticks = 1, first = 0;
  bool at_start = false;  ///< and at tick 0: outputs that are states are there from the start

  bool due(std::int64_t tick) const { return tick % ticks == first || (at_start && tick == 0); }
  bool operator==(const Period&) const = default;
};

/// Blocks of one type that lie one behind the other and run at the same ticks: one call of a kernel.
struct KernelCall {
  Kernel run;
  std::size_t first, end;  ///< offsets of the first block and behind the last in the memory of blocks [bytes]
  std::size_t count;
  int period;  ///< index in Plan::periods
  std::ptrdiff_t active =
      -1;          ///< place of what its blocks are active by, which is 0 while they are not; -1: always
  int guard = -1;  ///< index in Plan::guards of the guard that it runs; -1: none
  int late = -1;   ///< index in Plan::late of its one block; -1: it is none of these
};

/// Continuous states of a block whose update changes them, and that another update reads at the same instant.
/// They take their new values once all updates are done, so that each reads what was before.
struct LateStates {
  std::size_t block;                 ///< index in Plan::blocks
  std::size_t state, before, after;  ///< places in the workspace
  std::size_t size;
};

/// Where a signal lies, for recording and for messages.
struct SignalSlot {
  std::size_t offset = 0;
  Eigen::Index size = 1;
  Eigen::Index columns = 1;  ///< of a matrix, whose numbers lie column by column

  Eigen::Index rows() const { return size / columns; }
};

/// Numbers that are copied from one place of the workspace to another.
struct Copied {
  std::size_t from, to, size;
};

/// What happens as a guard changes (see engine/model/diagram/guard.hpp). While it is off, nothing that it
/// guards is called, and slopes are 0.
struct PlannedGuard {
  std::size_t block = 0;
  std::size_t active = 0;      ///< place of its output
  bool once_per_edge = false;  ///< is it active at single ticks, each of which is a beginning of its own?
  std::vector<int> inside;     ///< guards that it guards, by their index in Plan::guards
  std::vector<Copied> keep;    ///< outputs that solver stages write, at a tick, for what reads them while off
  std::vector<SignalSlot> slopes;  ///< of states that it guards
  std::vector<Copied> reset;       ///< initial values of all states inside; none where these are held
  std::vector<std::size_t> start;  ///< blocks inside that have start(), where states are reset
};

/// A loop of outputs that feed each other at the same instant, torn so that its blocks can be called in a
/// row.
struct SolvedLoop {
  std::string path;  ///< "error -> half -> twice -> error"
  std::vector<diagram::SignalRef> tears;
  std::vector<std::size_t> diagnostics;  ///< of its blocks, where they lie in the workspace
  std::size_t report = 0;                ///< where what is known of it in a run lies (solve::LoopReport)
};

/// Calls of a table that are made again and again until their loop is solved.
struct LoopCall {
  std::size_t first, end;  ///< calls of the table
  std::size_t loop;        ///< index in Plan::loops
  /// Of the signals that these calls compute those at which the loop is torn: guesses stand in their places.
  std::vector<SignalSlot> tears;
};

/// The crossings of one block.
struct CrossingCall {
  std::size_t block;  ///< index in Plan::blocks
  std::size_t first;  ///< index of its first number
  std::size_t count;
};

/// Where the numbers of a run lie in its workspace; offsets in doubles. Signals and continuous states lie
/// side by side, so that one sweep over them finds what is not finite.
struct Layout {
  static constexpr std::size_t time = 0;
  static constexpr std::size_t timed = 1;  ///< for which time Plan::timed was computed last
  static constexpr std::size_t first = 2;  ///< of what blocks have
  static constexpr std::size_t report_count = 10, loop_count = 7, event_count = 6;
  static constexpr double never = -1.0;  ///< stands at `timed` before the start
  std::size_t signals = first;
  std::size_t states = first;
  std::size_t state_count = 0;
  std::size_t derivatives = first;
  std::size_t discrete = first;
  std::size_t discrete_count = 0;
  std::size_t diagnostics = first;
  std::size_t diagnostic_count = 0;
  std::size_t constants = first;
  std::size_t report = first;  ///< of an implicit solver
  std::size_t loops = first;   ///< what is known of loops in a run
  std::size_t events = first;  ///< and of located events; lies behind all else
  std::size_t size = first;
};

/// One block as it is run.
struct PlannedBlock {
  std::size_t memory = 0;  ///< offset in the memory of blocks [bytes]
  Rate rate;
  std::vector<SignalSlot> outputs;
  std::vector<SignalSlot> states;
  std::vector<SignalSlot> derivatives;  ///< parallel to states; unused for discrete ones
  std::vector<SignalSlot> diagnostics;
  std::vector<std::vector<SignalSlot>> inputs;
  std::vector<SignalSlot> initial;  ///< values of states, where a guard resets these; else empty
  std::vector<SignalSlot> kept;     ///< outputs as they were at the tick, see PlannedGuard; else empty
  std::vector<Eigen::Index> sizes;  ///< parallel to BlockType::sizes
  bool slope_is_input = false;      ///< its input lies in the place of its slope: derivatives() is not called
  std::optional<AnyBlock> written;  ///< as its file gives it, where configure() or prepare() change it
  std::shared_ptr<const Configuration> configuration;  ///< what configure() answered, where it has one
};

/// What a run walks: the order of calls and the layout of memory. Nothing in it changes while runs use it.
struct Plan {
  diagram::Diagram diagram;
  std::int64_t steps = 0;  ///< ticks from 0 to stop
  std::vector<PlannedBlock> blocks;
  std::vector<int> memory_order;  ///< blocks as they lie in memory
  std::size_t block_bytes = 0;
  std::vector<Period> periods;  ///< of calls; the first is each tick
  Layout layout;
  std::vector<double> constants;

  std::vector<KernelCall> once;     ///< outputs that never change, computed at the start
  std::vector<KernelCall> timed;    ///< outputs that follow from the time alone, whenever that has changed
  std::vector<KernelCall> outputs;  ///< at every tick
  std::vector<KernelCall>
      stage;  ///< outputs on which derivatives depend, at the solver's stages between ticks
  std::vector<KernelCall> derivatives;
  std::vector<KernelCall> updates;
  std::vector<PlannedGuard> guards;  ///< each behind the one that guards it
  bool updates_continuous = false;   ///< may an update change a continuous state?
  std::vector<LateStates> late;

  std::vector<SolvedLoop> loops;
  std::vector<LoopCall> once_loops, timed_loops, output_loops, stage_loops;  ///< of the tables above

  /// The loops in one of the tables above.
  const std::vector<LoopCall>& loops_of(const std::vector<KernelCall>& table) const;

  /// True where a source may jump: the solver must not see the tick at the end of its step then.
  bool jumps = false;
  /// Tells whether steps are split at events.
  bool splits_steps() const { return crossing_count > 0 || !edges.empty(); }

  // Where events are located; empty otherwise.
  std::vector<std::size_t>
      edges;  ///< sources that declare when they jump or bend, by their index in Plan::blocks
  std::vector<CrossingCall> crossings;
  std::size_t crossing_count = 0;
  /// True where a block that crosses takes its branch from its inputs within a stage, and keeps none.
  bool branches = false;
  std::optional<std::size_t> stop_crossing;  ///< which of the numbers is that of `stop_when`
  /// What crossings depend on between ticks and only the solver and the time change: it is computed at the
  /// end of a step, and `rest` is then left of `outputs`. Where nothing is of that kind, both are empty.
  std::vector<KernelCall> ahead, rest;
  std::vector<KernelCall> crossing_outputs;  ///< what else crossings depend on between ticks
  std::vector<KernelCall> crossing_starts;   ///< of both, what no stage computes
  std::vector<KernelCall> event_outputs;     ///< of what follows at every instant
  std::vector<KernelCall> event_befores;     ///< the same without guards; empty where none follows
  std::vector<KernelCall> event_updates;
  /// Outputs just before an instant, where both of its sides are recorded, and after one at which a block
  /// ends the run.
  std::vector<KernelCall> sides;
  std::vector<LoopCall> side_loops;
  std::vector<LoopCall> ahead_loops, rest_loops, crossing_loops, crossing_start_loops, event_loops,
      event_before_loops;

  SignalSlot slot(const diagram::SignalRef& signal) const;
  std::optional<unit::Dimension> dimension(const diagram::SignalRef& signal) const;
  /// Where what a stop condition reads lies in the workspace.
  std::size_t offset(const diagram::SignalRef& variable) const {
    return variable.block < 0 ? Layout::time : slot(variable).offset;
  }
  /// True where both sides of each instant are recorded. Such a run is interpreted, and alone.
  bool records_instants() const {
    return std::ranges::any_of(diagram.records, &diagram::RecordRequest::instants);
  }
  double time_of(std::int64_t tick) const { return static_cast<double>(tick) * diagram.step; }
};

/// How many steps a time is; nothing if it is not a whole number of them. Decimal times are not exact in
/// binary, so a difference that only rounding explains is none.
std::optional<std::int64_t> whole_ticks(double time, double step);

/// Plans a checked diagram. Throws Error for what shows only here: algebraic loops, sizes that do not agree,
/// rates that do not fit the step, and what blocks refuse about their own parameters.
Plan make_plan(diagram::Diagram diagram);

}  // namespace stepwire::plan
