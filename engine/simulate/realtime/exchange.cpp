#include "engine/simulate/realtime/exchange.hpp"

namespace stepwire::realtime {

namespace {

constexpr std::size_t at_once = 1 << 14;  // numbers per read from the ring

}  // namespace

void SignalTap::push(std::int64_t tick, const double* values) {
  Selection* const selection = selected_.load(std::memory_order_acquire);
  if (!selection) return;
  std::vector<double>& row = selection->row;
  row[1] = static_cast<double>(tick);
  for (std::size_t i = 0; i < selection->places.size(); ++i)
    row[before_values + i] = values[selection->places[i]];
  if (!ring_.push(row.data(), row.size())) lost_.add();
}

void SignalTap::select(std::vector<std::size_t> places) {
  auto next = std::make_unique<Selection>();
  next->number = selections_.empty() ? 1 : selections_.back()->number + 1;
  next->row.assign(before_values + places.size(), 0.0);
  next->row[0] = static_cast<double>(next->number);
  next->places = std::move(places);
  selected_.store(next.get(), std::memory_order_release);
  selections_.push_back(std::move(next));
}

/// Removes older selections. A row with one selection proves that the loop thread no longer uses the earlier
/// ones.
void SignalTap::forget_before(std::int64_t number) {
  while (selections_.front()->number < number) selections_.pop_front();
}

bool SignalTap::take_one(const Take& take, std::size_t& at) {
  if (at + before_values > filled_) return false;
  forget_before(static_cast<std::int64_t>(numbers_[at]));
  const Selection& selection = *selections_.front();
  const std::size_t size = before_values + selection.places.size();
  if (at + size > filled_) return false;
  take(static_cast<std::int64_t>(numbers_[at + 1]), selection.places,
       {numbers_.data() + at + before_values, selection.places.size()});
  at += size;
  return true;
}

void SignalTap::take_all(const Take& take) {
  while (true) {
    if (numbers_.size() < filled_ + at_once) numbers_.resize(filled_ + at_once);
    const std::size_t got = ring_.pop(numbers_.data() + filled_, numbers_.size() - filled_);
    if (got == 0) return;
    filled_ += got;
    std::size_t at = 0;
    while (take_one(take, at)) {
    }
    std::copy(numbers_.begin() + static_cast<std::ptrdiff_t>(at),
              numbers_.begin() + static_cast<std::ptrdiff_t>(filled_), numbers_.begin());
    filled_ -= at;
  }
}

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
