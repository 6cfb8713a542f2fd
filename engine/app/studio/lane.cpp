#include "engine/app/studio/lane.hpp"

#include <algorithm>
#include <utility>

namespace stepwire::studio {

using Clock = std::chrono::steady_clock;

Lane::Lane(Work tick, std::chrono::milliseconds period)
    : tick_(std::move(tick)), period_(period), thread_([this] { run(); }) {}

void Lane::post(Work work, int sender) {
  const std::lock_guard lock(mutex_);
  if (ends_) return;
  auto found = std::ranges::find(waiting_, sender, &Sender::number);
  if (found == waiting_.end()) found = waiting_.insert(found, {sender, {}});
  found->works.push_back(std::move(work));
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

/// Waits for the next work; returns an empty function at the end of the period or of the lane.
Lane::Work Lane::next() {
  std::unique_lock lock(mutex_);
  changed_.wait_for(lock, period_, [this] { return ends_ || !waiting_.empty(); });
  if (waiting_.empty()) return {};
  Sender sender = std::move(waiting_.front());
  waiting_.pop_front();
  Work work = std::move(sender.works.front());
  sender.works.pop_front();
  if (!sender.works.empty()) waiting_.push_back(std::move(sender));
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
