#include "engine/simulate/run/call_table.hpp"

#include <algorithm>

namespace stepwire::run {

namespace {

std::size_t unknowns_of(const plan::LoopCall& call) {
  std::size_t unknowns = 0;
  for (const plan::SignalSlot& tear : call.tears) unknowns += static_cast<std::size_t>(tear.size);
  return unknowns;
}

}  // namespace

CallTable::Loop::Loop(BoundBlocks& bound, const plan::LoopCall& call)
    : first(call.first),
      end(call.end),
      unknowns(unknowns_of(call)),
      blocks(bound),
      solver(static_cast<Eigen::Index>(unknowns)) {
  const plan::Plan& plan = bound.plan();
  for (std::size_t t = 0; t < call.tears.size(); ++t)
    tears.push_back({call.tears[t].offset, static_cast<std::size_t>(call.tears[t].size), call.residuals[t]});
  const plan::SolvedLoop& loop = plan.loops[call.loop];
  const diagram::AlgebraicLoops& options = plan.diagram.algebraic_loops;
  task = {tears.data(), tears.size(),       loop.diagnostics.data(), loop.diagnostics.size(),
          loop.report,  plan::Layout::time, options.tolerance,       options.max_iterations};
}

void CallTable::Loop::find_starts(const std::vector<plan::KernelCall>& batches) {
  const plan::Plan& plan = blocks.plan();
  const auto is_called = [&](std::size_t memory) {
    return std::any_of(batches.begin() + static_cast<std::ptrdiff_t>(first),
                       batches.begin() + static_cast<std::ptrdiff_t>(end), [&](const plan::KernelCall& call) {
                         return call.first <= memory && memory < call.end;
                       });
  };
  for (std::size_t b = 0; b < plan.blocks.size(); ++b)
    if (plan.diagram.blocks[b].type().start && is_called(plan.blocks[b].memory)) starts.push_back(b);
}

void CallTable::Loop::forget(double* values) const {
  for (const solve::Tear& tear : tears) {
    std::fill_n(values + tear.offset, tear.size, 0.0);
    std::fill_n(values + tear.residual, tear.size, 0.0);
  }
  std::fill_n(values + task.report, solve::LoopReport::count, 0.0);
  for (const std::size_t block : starts) blocks.start(block);
}

CallTable::CallTable(const std::vector<plan::KernelCall>& batches, BoundBlocks& blocks, Participants& who)
    : batches_(batches), plan_(blocks.plan()), values_(blocks.values()), who_(who) {
  const plan::Plan& plan = plan_;
  for (const plan::KernelCall& batch : batches)
    calls_.push_back({batch.run, blocks.memory() + batch.first, blocks.memory() + batch.end});
  loops_.reserve(plan.loops_of(batches).size());  // tasks point into it: no reallocation
  for (const plan::LoopCall& loop : plan.loops_of(batches))
    loops_.emplace_back(blocks, loop).find_starts(batches);
  if (who.guards) add_gates();
  for (const plan::KernelCall& batch : batches)
    if (batch.late >= 0) late_.push_back(plan.late[static_cast<std::size_t>(batch.late)]);
}

/// Computes the gate of each call. Calls of one guard are adjacent as far as the order permits, so an
/// inactive guard skips them in one step.
void CallTable::add_gates() {
  static constexpr double always = 1.0;
  gates_.resize(batches_.size());
  for (std::size_t i = batches_.size(); i-- > 0;) {
    const bool same = i + 1 < batches_.size() && batches_[i + 1].active == batches_[i].active;
    gates_[i] = {batches_[i].active < 0 ? &always : values_ + batches_[i].active,
                 same ? gates_[i + 1].next : i + 1};
  }
}

void CallTable::run() {
  if (is_watched() || !loops_.empty() || !gates_.empty() || !late_.empty()) return run_slowly();
  const Call* call = calls_.data();
  const Call* const end = call + calls_.size();
  // Unrolled by four: most calls are so short that the loop counter is measurable.
  for (; end - call >= 4; call += 4) {
    call[0].run(call[0].first, call[0].end);
    call[1].run(call[1].first, call[1].end);
    call[2].run(call[2].first, call[2].end);
    call[3].run(call[3].first, call[3].end);
  }
  for (; call != end; ++call) call->run(call->first, call->end);
}

void CallTable::run_due() {
  if (who_.due.size() == 1) return run();  // the step is the only period
  run_slowly();
}

void CallTable::forget_loops() {
  for (const Loop& loop : loops_) loop.forget(values_);
}

void CallTable::run_slowly() {
  begin_late();
  is_watched() ? run_watched() : run_range(0, calls_.size());
  end_late();
}

/// Runs all calls and measures the range of the probe. Calls between ticks are of continuous blocks, which
/// are due at every tick.
void CallTable::run_watched() {
  run_range(0, who_.probe->first);
  who_.probe->enter();
  run_range(who_.probe->first, who_.probe->end);
  who_.probe->leave();
  run_range(who_.probe->end, calls_.size());
}

void CallTable::begin_late() {
  for (const plan::LateStates& late : late_) {
    std::copy_n(values_ + late.state, late.size, values_ + late.before);
    std::copy_n(values_ + late.state, late.size, values_ + late.after);
  }
}

void CallTable::set_aside(const plan::KernelCall& call) {
  const plan::LateStates& late = plan_.late[static_cast<std::size_t>(call.late)];
  std::copy_n(values_ + late.state, late.size, values_ + late.after);
  std::copy_n(values_ + late.before, late.size, values_ + late.state);
}

void CallTable::end_late() {
  for (const plan::LateStates& late : late_)
    std::copy_n(values_ + late.after, late.size, values_ + late.state);
}

void CallTable::run_range(std::size_t first, std::size_t end) {
  for (Loop& loop : loops_) {
    if (loop.first < first || loop.first >= end) continue;
    run_calls(first, loop.first);
    solve(loop);
    first = loop.end;
  }
  run_calls(first, end);
}

void CallTable::run_calls(std::size_t first, std::size_t end) {
  if (!gates_.empty()) return run_guarded(first, end);
  for (std::size_t i = first; i < end; ++i)
    if (who_.due[static_cast<std::size_t>(batches_[i].period)]) {
      calls_[i].run(calls_[i].first, calls_[i].end);
      if (batches_[i].late >= 0) set_aside(batches_[i]);
    }
}

void CallTable::run_guarded(std::size_t first, std::size_t end) {
  for (std::size_t i = first; i < end; ++i) {
    if (*gates_[i].active == 0.0) {
      i = gates_[i].next - 1;
      continue;
    }
    const plan::KernelCall& batch = batches_[i];
    if (!who_.due[static_cast<std::size_t>(batch.period)]) continue;
    const bool was = batch.guard >= 0 && who_.guards->active(static_cast<std::size_t>(batch.guard));
    calls_[i].run(calls_[i].first, calls_[i].end);
    if (batch.late >= 0) set_aside(batch);
    if (batch.guard >= 0) who_.guards->changed(static_cast<std::size_t>(batch.guard), was);
  }
}

void CallTable::solve(Loop& loop) {
  loop.solver.solve(loop.task, values_, [&] { run_calls(loop.first, loop.end); });
}

}  // namespace stepwire::run
