// How the tables of calls are gone through.
#include "engine/simulate/run/executor.hpp"

namespace stepwire::run {

Executor::Table::Table(const plan::Plan& plan, const std::vector<plan::KernelCall>& batches,
                       std::byte* blocks)
    : batches(batches) {
  for (const plan::KernelCall& batch : batches)
    calls.push_back({batch.run, blocks + batch.first, blocks + batch.end});
  loops.reserve(plan.loops_of(batches).size());  // none is moved: its task points into it
  for (const plan::LoopCall& loop : plan.loops_of(batches)) loops.emplace_back(plan, loop);
}

/// What a guard leaves out lies in a row, as far as the order lets it, and is passed over in one go.
void Executor::Table::add_gates(const double* values) {
  static constexpr double always = 1.0;
  gates.resize(batches.size());
  for (std::size_t i = batches.size(); i-- > 0;) {
    const bool goes_on = i + 1 < batches.size() && batches[i + 1].active == batches[i].active;
    gates[i] = {batches[i].active < 0 ? &always : values + batches[i].active,
                goes_on ? gates[i + 1].next : i + 1};
  }
}

void Executor::run_guarded(const Table& table, std::size_t first, std::size_t end) {
  for (std::size_t i = first; i < end; ++i) {
    if (*table.gates[i].active == 0.0) {
      i = table.gates[i].next - 1;
      continue;
    }
    const plan::KernelCall& batch = table.batches[i];
    if (!due_[static_cast<std::size_t>(batch.period)]) continue;
    const bool was = batch.guard >= 0 && guards_->active(static_cast<std::size_t>(batch.guard));
    table.calls[i].run(table.calls[i].first, table.calls[i].end);
    if (batch.guard >= 0) guards_->changed(static_cast<std::size_t>(batch.guard), was);
  }
}

void Executor::run(Table& table) {
  if (watcher_ && watcher_->phase == &table.batches) return run_watched(table);
  if (!table.loops.empty() || !table.gates.empty()) return run_range(table, 0, table.calls.size());
  const Table::Call* call = table.calls.data();
  const Table::Call* const end = call + table.calls.size();
  // Four at a time: most calls do so little that counting them is felt.
  for (; end - call >= 4; call += 4) {
    call[0].run(call[0].first, call[0].end);
    call[1].run(call[1].first, call[1].end);
    call[2].run(call[2].first, call[2].end);
    call[3].run(call[3].first, call[3].end);
  }
  for (; call != end; ++call) call->run(call->first, call->end);
}

void Executor::follow_time() {
  double* values = workspace_.values.data();
  if (values[plan::Layout::timed] == values[plan::Layout::time] || plan_.timed.empty()) return;
  values[plan::Layout::timed] = values[plan::Layout::time];
  run(timed_);
}

void Executor::run_due(Table& table) {
  if (due_.size() == 1) return run(table);  // nothing is slower than the step
  if (watcher_ && watcher_->phase == &table.batches) return run_watched(table);
  run_range(table, 0, table.calls.size());
}

void Executor::run_calls(const Table& table, std::size_t first, std::size_t end) {
  if (!table.gates.empty()) return run_guarded(table, first, end);
  for (std::size_t i = first; i < end; ++i)
    if (due_[static_cast<std::size_t>(table.batches[i].period)])
      table.calls[i].run(table.calls[i].first, table.calls[i].end);
}

/// What runs between ticks is continuous, and what is continuous is due at every tick.
void Executor::run_watched(Table& table) {
  run_range(table, 0, watcher_->first);
  watcher_->enter();
  run_range(table, watcher_->first, watcher_->end);
  watcher_->leave();
  run_range(table, watcher_->end, table.calls.size());
}

}  // namespace stepwire::run
