#include <algorithm>

#include "engine/model/diagram/guard_types.hpp"
#include "engine/model/plan/active.hpp"
#include "engine/model/plan/draft.hpp"

namespace stepwire::plan {

namespace {

int period_index(Plan& plan, const Period& period) {
  const auto found = std::ranges::find(plan.periods, period);
  const auto index = found - plan.periods.begin();
  if (found == plan.periods.end()) plan.periods.push_back(period);
  return static_cast<int>(index);
}

bool has_one_element_each(const Draft::Block& block) {
  const auto all_one = [](const std::vector<Eigen::Index>& sizes) {
    return std::all_of(sizes.begin(), sizes.end(), [](Eigen::Index size) { return size == 1; });
  };
  return all_one(block.output_sizes) && all_one(block.state_sizes) && all_one(block.input_sizes);
}

/// Returns the kernel assumptions that hold for a block.
Specialization specialization_of(const Draft& draft, std::size_t block) {
  if (!has_one_element_each(draft.blocks[block])) return Specialization::nothing;
  if (!draft.blocks[block].says.slope_source.first.empty()) return Specialization::plain_slope;
  const int list = draft.type(block).input("u");
  if (list < 0) return Specialization::one_element;
  switch (draft.plan.diagram.blocks[block].inputs[static_cast<std::size_t>(list)].size()) {
    case 0:
      return Specialization::nothing;  // an unconnected list is empty
    case 2:
      return Specialization::two_in_list;
    case 3:
      return Specialization::three_in_list;
    default:
      return Specialization::one_element;
  }
}

/// Returns the most specialised kernel that is valid for a block.
Kernel kernel_of(const Draft& draft, std::size_t block, const Kernels& kernels) {
  const Specialization specialization = specialization_of(draft, block);
  return specialization == Specialization::nothing || kernels[specialization]
             ? kernels[specialization]
             : kernels[Specialization::one_element];
}

/// Returns the index of a guard in Plan::guards; -1 for other blocks.
int guard_of(const Plan& plan, std::size_t block) {
  if (&plan.diagram.blocks[block].type() != &diagram::guard_type()) return -1;
  const auto found = std::ranges::find(plan.guards, block, &PlannedGuard::block);
  return found == plan.guards.end() ? -1 : static_cast<int>(found - plan.guards.begin());
}

/// Returns the index of a block in Plan::late; -1 for other blocks.
int late_of(const Plan& plan, std::size_t block) {
  const auto found = std::ranges::find(plan.late, block, &LateStates::block);
  return found == plan.late.end() ? -1 : static_cast<int>(found - plan.late.begin());
}

/// Appends a call, or extends the last one by an adjacent block; calls before `closed` are not extended.
void append(std::vector<KernelCall>& batches, const Draft& draft, std::size_t block, const Kernels& kernels,
            std::size_t closed = 0, bool at_start = false, bool updates = false) {
  Plan& plan = draft.plan;
  const Kernel kernel = kernel_of(draft, block, kernels);
  const Rate& rate = plan.blocks[block].rate;
  const std::size_t bytes = draft.type(block).bytes, memory = plan.blocks[block].memory;
  const int period = period_index(plan, {rate.ticks, rate.first, at_start && rate.first > 0});
  const std::ptrdiff_t active = active_of(plan, block);
  const std::vector<KernelCall>* const evaluate[] = {&plan.outputs, &plan.rest, &plan.event_outputs};
  const int late = updates ? late_of(plan, block) : -1;
  const bool evaluates_guard =
      std::ranges::find(evaluate, &batches) != std::end(evaluate) && guard_of(plan, block) >= 0;
  if (batches.size() > closed) {
    KernelCall& last = batches.back();
    if (last.run == kernel && last.period == period && last.end == memory && last.active == active &&
        last.guard < 0 && !evaluates_guard && last.late < 0 && late < 0) {
      ++last.count;
      last.end += bytes;
      return;
    }
  }
  batches.push_back({kernel, memory, memory + bytes, 1, period, active,
                     evaluates_guard ? guard_of(plan, block) : -1, late});
}

/// A table of outputs under construction.
struct OutputTable {
  std::vector<KernelCall>& calls;
  std::vector<LoopCall>& loops;
  bool (*has)(const Draft::Block& block);  ///< membership of a block neither constant nor timed
  /// True for a block that this table calls as at ticks and events, instead of stages between them.
  bool (*at_instants)(const Draft::Block& block) = [](const Draft::Block&) { return false; };
  std::size_t closed = 0;  ///< number of calls that must not be extended

  void close() { closed = calls.size(); }
};

/// Distributes the outputs of blocks to the tables, with loops around them.
class OutputTables {
 public:
  explicit OutputTables(Draft& draft) : draft_(draft) {}

  void run(const CallOrder& order) {
    auto loop = order.loops.begin();
    for (std::size_t i = 0; i < order.blocks.size(); ++i) {
      if (loop != order.loops.end() && i == loop->first) close();
      append(static_cast<std::size_t>(order.blocks[i]));
      if (loop == order.loops.end() || i + 1 < loop->end) continue;
      end_loop(static_cast<std::size_t>(loop - order.loops.begin()));
      ++loop;
    }
  }

 private:
  void close() {
    for (OutputTable& table : tables_) table.close();
  }

  void append(std::size_t block) {
    const Rate& rate = draft_.plan.blocks[block].rate;
    if (rate.kind == Rate::Kind::constant) return append(once_, block);
    if (draft_.blocks[block].timed) return append(timed_, block);
    for (OutputTable& table : tables_)
      if (table.has(draft_.blocks[block])) append(table, block);
  }
  void append(OutputTable& table, std::size_t block) {
    const BlockType& type = draft_.type(block);
    const bool at_instant = table.at_instants(draft_.blocks[block]);
    const bool differs = at_instant && draft_.blocks[block].differs_at_instants;
    plan::append(table.calls, draft_, block, differs ? type.run_outputs_at_instant : type.run_outputs,
                 table.closed, at_instant && follows_state(block));
  }

  /// True where outputs depend on states alone: these exist before the first run.
  bool follows_state(std::size_t block) const {
    const BlockType& type = draft_.type(block);
    for (std::size_t i = 0; i < type.inputs.size(); ++i)
      for (std::size_t o = 0; o < type.outputs.size(); ++o)
        if (!draft_.diagram().blocks[block].inputs[i].empty() && draft_.depends(block, i, o)) return false;
    return !type.states.empty();
  }

  /// Makes a loop of the calls since its begin.
  void end_loop(std::size_t loop) {
    for (OutputTable& table : tables_) {
      LoopCall call{table.closed, table.calls.size(), loop, {}, {}};
      table.close();
      if (call.first == call.end) continue;
      add_tears(table, call);
      if (!call.tears.empty()) table.loops.push_back(std::move(call));
    }
  }
  void add_tears(const OutputTable& table, LoopCall& call) const {
    const SolvedLoop& loop = draft_.plan.loops[call.loop];
    std::size_t residual = loop.residuals;
    for (const diagram::SignalRef& tear : loop.tears) {
      const SignalSlot& slot = draft_.plan.slot(tear);
      if (&table == &once_ || &table == &timed_ ||
          table.has(draft_.blocks[static_cast<std::size_t>(tear.block)])) {
        call.tears.push_back(slot);
        call.residuals.push_back(residual);
      }
      residual += static_cast<std::size_t>(slot.size);
    }
  }

  bool has_ahead() const { return std::ranges::any_of(draft_.blocks, &Draft::Block::ahead); }
  static bool never(const Draft::Block&) { return false; }
  static bool always(const Draft::Block&) { return true; }
  static bool in_stages(const Draft::Block& block) { return block.in_stages; }
  static bool ahead(const Draft::Block& block) { return block.ahead; }
  static bool not_ahead(const Draft::Block& block) { return !block.ahead; }
  static bool for_crossings(const Draft::Block& block) { return block.for_crossings && !block.ahead; }
  static bool starts_crossings(const Draft::Block& block) { return block.for_crossings && !block.in_stages; }
  static bool at_events(const Draft::Block& block) { return block.at_events; }
  static bool on_sides(const Draft::Block& block) { return block.on_sides; }
  static bool between(const Draft::Block& block) { return block.between; }
  static bool has_no_crossing(const Draft::Block& block) { return block.crossings == 0; }
  static bool for_left(const Draft::Block& block) { return block.for_left; }
  static bool before_guards(const Draft::Block& block) { return block.before_guards; }

  Draft& draft_;
  Plan& plan_ = draft_.plan;
  std::vector<LoopCall> no_loops_;  ///< Diagrams with loops have no external solver.
  OutputTable tables_[13] = {{plan_.once, plan_.once_loops, never},
                             {plan_.timed, plan_.timed_loops, never},
                             {plan_.outputs, plan_.output_loops, always, always},
                             {plan_.stage, plan_.stage_loops, in_stages},
                             {plan_.ahead, plan_.ahead_loops, ahead},
                             {plan_.rest, plan_.rest_loops, has_ahead() ? not_ahead : never, always},
                             {plan_.crossing_outputs, plan_.crossing_loops, for_crossings},
                             {plan_.crossing_starts, plan_.crossing_start_loops, starts_crossings},
                             {plan_.event_outputs, plan_.event_loops, at_events, always},
                             {plan_.event_befores, plan_.event_before_loops, before_guards, always},
                             {plan_.sides, plan_.side_loops, on_sides},
                             {plan_.between, no_loops_, between, has_no_crossing},
                             {plan_.lefts, plan_.left_loops, for_left}};
  OutputTable &once_ = tables_[0], &timed_ = tables_[1];
};

void append_derivatives(Draft& draft, std::size_t block) {
  const BlockType& type = draft.type(block);
  if (type.run_derivatives && !draft.plan.blocks[block].slope_is_input)
    append(draft.plan.derivatives, draft, block, type.run_derivatives);
}

/// Appends the update just before each instant. A block with periods of its own needs it before its own
/// ticks, which are not yet due there: the call is made before each tick.
void append_left_update(Draft& draft, std::size_t block) {
  append(draft.plan.left_updates, draft, block, draft.type(block).run_update_before_instant);
  draft.plan.left_updates.back().period = 0;
}

void append_updates(Draft& draft, std::size_t block) {
  if (!draft.blocks[block].updates) return;
  const BlockType& type = draft.type(block);
  append(draft.plan.updates, draft, block, type.run_update, 0, false, true);
  if (type.at_end) append(draft.plan.end_updates, draft, block, type.run_update, 0, false, true);
  if (draft.blocks[block].updates_before_instant) append_left_update(draft, block);
  if (draft.blocks[block].updates_at_events)
    append(draft.plan.event_updates, draft, block,
           type.run_update_at_event ? type.run_update_at_event : type.run_update, 0, false, true);
  draft.plan.updates_continuous =
      draft.plan.updates_continuous ||
      (type.has_continuous_state() && !draft.blocks[block].says.update_keeps_outputs);
}

/// Marks all blocks that may depend on time alone, then unmarks those that depend on other blocks.
class TimedBlocks {
 public:
  explicit TimedBlocks(Draft& draft) : draft_(draft), readers_(draft.blocks.size()) {
    for (std::size_t b = 0; b < draft.blocks.size(); ++b) {
      draft.blocks[b].timed = may_be_timed(b);
      for (const auto& sources : draft.diagram().blocks[b].inputs)
        for (const diagram::Source& source : sources)
          if (source.block >= 0) readers_[static_cast<std::size_t>(source.block)].push_back(b);
    }
  }

  void run() {
    for (std::size_t b = 0; b < draft_.blocks.size(); ++b) check(b);
    while (!refused_.empty()) {
      const std::size_t block = refused_.back();
      refused_.pop_back();
      for (const std::size_t reader : readers_[block]) check(reader);
    }
  }

 private:
  bool is_constant(std::size_t block) const {
    return draft_.plan.blocks[block].rate.kind == Rate::Kind::constant;
  }

  bool may_be_timed(std::size_t block) const {
    return draft_.blocks[block].computes && !draft_.blocks[block].differs_at_instants &&
           !draft_.remembers(block) && draft_.diagram().blocks[block].guard < 0 &&
           draft_.plan.blocks[block].rate.kind == Rate::Kind::continuous && !draft_.is_steady(block);
  }

  bool is_timed(const diagram::Source& source) const {
    if (source.block < 0) return true;
    const auto block = static_cast<std::size_t>(source.block);
    return draft_.blocks[block].timed || is_constant(block);
  }

  void check(std::size_t block) {
    if (!draft_.blocks[block].timed) return;
    for (const auto& sources : draft_.diagram().blocks[block].inputs)
      for (const diagram::Source& source : sources)
        if (!is_timed(source)) draft_.blocks[block].timed = false;
    if (!draft_.blocks[block].timed) refused_.push_back(block);
  }

  Draft& draft_;
  std::vector<std::vector<std::size_t>> readers_;  ///< readers of each block
  std::vector<std::size_t> refused_;               ///< whose readers are not yet unmarked
};

/// Determines whether an output may jump by time alone. Blocks with a clock may, and blocks that read only
/// such blocks and constants, unless they are smooth.
class Jumps {
 public:
  explicit Jumps(const Draft& draft) : draft_(draft), follows_time_(draft.blocks.size(), false) {}

  bool run() {
    while (find_more()) continue;
    for (std::size_t b = 0; b < follows_time_.size(); ++b)
      if (follows_time_[b] && !is_smooth(b)) return true;
    return false;
  }

 private:
  bool is_smooth(std::size_t block) const {
    return draft_.type(block).smooth || draft_.blocks[block].says.smooth;
  }

  bool find_more() {
    bool found = false;
    for (std::size_t b = 0; b < follows_time_.size(); ++b)
      if (!follows_time_[b] && follows_time(b)) found = follows_time_[b] = true;
    return found;
  }

  bool follows_time(std::size_t block) const {
    const Rate::Kind kind = draft_.plan.blocks[block].rate.kind;
    if (kind != Rate::Kind::continuous || !draft_.blocks[block].computes) return false;
    const auto& clocks = draft_.type(block).clocks;
    // Smooth blocks with inputs have a clock for their diagnostics.
    bool time =
        std::ranges::any_of(clocks, [](const ClockSpec& clock) { return clock.bind_time != nullptr; });
    if (time && !is_smooth(block)) return true;
    for (const auto& sources : draft_.plan.diagram.blocks[block].inputs)
      for (const diagram::Source& source : sources) {
        if (source.block < 0) continue;
        const auto from = static_cast<std::size_t>(source.block);
        if (!follows_time_[from] && draft_.plan.blocks[from].rate.kind != Rate::Kind::constant) return false;
        time = time || follows_time_[from];
      }
    return time;
  }

  const Draft& draft_;
  std::vector<bool> follows_time_;
};

}  // namespace

void make_schedule(Draft& draft, const CallOrder& order) {
  draft.plan.periods = {Period{}};
  OutputTables(draft).run(order);
  for (const int b : draft.plan.memory_order) append_derivatives(draft, static_cast<std::size_t>(b));
  // Updates of continuous states come last, so that a discrete block that reads such a state sees its value
  // at the tick. Such updates may read each other's states; their canonical order makes them independent of
  // the file.
  for (const bool continuous : {false, true})
    for (const int b : continuous ? draft.canonical : draft.plan.memory_order)
      if (const auto block = static_cast<std::size_t>(b);
          draft.type(block).has_continuous_state() == continuous)
        append_updates(draft, block);
}

void find_timed(Draft& draft) {
  TimedBlocks(draft).run();
  draft.plan.jumps = !draft.diagram().solver.empty() && Jumps(draft).run();
}

}  // namespace stepwire::plan
