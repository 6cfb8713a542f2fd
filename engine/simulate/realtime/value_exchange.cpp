#include "engine/simulate/realtime/value_exchange.hpp"

namespace stepwire::realtime {

run::Executor& ValueExchange::at_tick() noexcept {
  if (!offered_.load(std::memory_order_acquire)) return runs_[active_];
  const run::Workspace& now = runs_[active_].workspace();
  active_ = 1 - active_;
  runs_[active_].restore(now);
  offered_.store(false, std::memory_order_relaxed);
  taken_.store(now.tick, std::memory_order_release);
  return runs_[active_];
}

void ValueExchange::offer(const Change& change) {
  change(runs_[1 - active_]);
  taken_.store(none, std::memory_order_relaxed);
  offered_.store(true, std::memory_order_release);
}

std::optional<std::int64_t> ValueExchange::taken() const {
  const std::int64_t tick = taken_.load(std::memory_order_acquire);
  return tick == none ? std::nullopt : std::optional(tick);
}

void ValueExchange::change_both(const Change& change) {
  change(runs_[1 - active_]);  // throws for a refused value, with nothing changed
  change(runs_[active_]);
}

}  // namespace stepwire::realtime
