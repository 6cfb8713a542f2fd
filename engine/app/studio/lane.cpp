#include "engine/app/studio/lane.hpp"

#include <utility>

namespace stepwire::studio {

using Clock = std::chrono::steady_clock;

Lane::Lane(Work tick, std::chrono::milliseconds period)
    : tick_(std::move(tick)), period_(period), thread_([this] { run(); }) {}

void Lane::post(Work work) {
  const std::lock_guard lock(mutex_);
  if (ends_) return;
  waiting_.push_back(std::move(work));
  changed_.notify_one();
}

void Lane::stop() {
  {
    const std::lock_guard lock(mutex_);
    ends_ = true;
    waiting_.clear();
    changed_.notify_one();
  }
  if (thread_.joinable()) thread_.join();
}

/// Empty where the period is over or the lane ends.
Lane::Work Lane::next() {
  std::unique_lock lock(mutex_);
  changed_.wait_for(lock, period_, [this] { return ends_ || !waiting_.empty(); });
  if (waiting_.empty()) return {};
  Work work = std::move(waiting_.front());
  waiting_.pop_front();
  return work;
}

void Lane::run() {
  Clock::time_point ticked = Clock::now();
  for (bool ends = false; !ends;) {
    if (const Work work = next()) work();
    {
      const std::lock_guard lock(mutex_);
      ends = ends_;
    }
    if (!ends && Clock::now() - ticked < period_) continue;
    if (tick_) tick_();
    ticked = Clock::now();
  }
}

}  // namespace stepwire::studio
