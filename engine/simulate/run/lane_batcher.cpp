#include "engine/simulate/run/lane_batcher.hpp"

#include <algorithm>
#include <atomic>
#include <exception>
#include <thread>
#include <utility>

#include "engine/base/parallel/parallel.hpp"

namespace stepwire::run {

/// Group of tasks that threads share. It keeps LaneBatcher::expected_ equal to the number of threads that may
/// bring runs. The thread that begins the group is already counted.
class LaneBatcher::Tasks {
 public:
  Tasks(LaneBatcher& batcher, std::size_t count, std::size_t threads)
      : batcher_(batcher), left_(count), threads_(threads) {
    change([] {});
  }
  ~Tasks() {
    change([this] { left_ = 0; });
  }
  Tasks(const Tasks&) = delete;
  Tasks& operator=(const Tasks&) = delete;

  void begun(std::size_t threads) {
    change([&] { threads_ -= wanted_ - threads; });
  }
  void done() {
    change([this] { --left_; });
  }
  void lose_thread() {
    change([this] { --left_, --threads_; });
  }

 private:
  template <class Change>
  void change(const Change& change) {
    const std::lock_guard lock(batcher_.mutex_);
    change();
    const std::size_t now = std::max<std::size_t>(std::min(left_, threads_), 1) - 1;
    batcher_.expected_ += now;
    batcher_.expected_ -= std::exchange(expected_, now);
    batcher_.changed_.notify_all();
  }

  LaneBatcher& batcher_;
  std::size_t left_, threads_;
  const std::size_t wanted_ = threads_;
  std::size_t expected_ = 0;
};

unsigned LaneBatcher::threads(unsigned cores) const {
  const unsigned all = cores > 0 ? cores : std::max(1u, std::thread::hardware_concurrency());
  return all * static_cast<unsigned>(runner_.most_lanes());
}

void LaneBatcher::in_parallel(std::size_t count, unsigned threads,
                              const std::function<void(std::size_t)>& task) {
  const std::size_t wanted = std::clamp<std::size_t>(count, 1, std::max(1u, threads));
  Tasks tasks(*this, count, wanted);
  std::atomic<std::size_t> next = 0;
  const auto work = [&] {
    try {
      for (std::size_t i = next++; i < count; i = next++) {
        task(i);
        tasks.done();
      }
    } catch (...) {
      tasks.lose_thread();
      throw;
    }
  };
  parallel::on_threads(static_cast<unsigned>(wanted), work, [&](std::size_t begun) { tasks.begun(begun); });
}

bool LaneBatcher::run(std::size_t member, const plan::CompiledPlan* alone, PendingRun& run) {
  if (runner_.at_once(member) == 1) return false;
  Waiting own{member, &run};
  std::unique_lock lock(mutex_);
  waiting_.push_back(&own);
  changed_.notify_all();
  while (!own.ended) {
    const bool begins = std::ranges::find(waiting_, &own) != waiting_.end();
    if (begins && may_go(member))
      step(member, alone, lock);
    else
      changed_.wait(lock);
  }
  if (own.failure) std::rethrow_exception(own.failure);
  return own.together;
}

std::size_t LaneBatcher::waiting_for(std::size_t member) const {
  return static_cast<std::size_t>(std::ranges::count(waiting_, member, &Waiting::member));
}

/// True if a group of this plan may start. Either its lanes are full, or all threads wait and it is the plan
/// with the most waiting runs (the first of equal ones).
bool LaneBatcher::may_go(std::size_t member) const {
  if (waiting_for(member) >= runner_.at_once(member)) return true;
  if (waiting_.size() + busy_ < expected_) return false;
  const auto most =
      std::ranges::max_element(waiting_, {}, [this](const Waiting* one) { return waiting_for(one->member); });
  return (*most)->member == member;
}

std::vector<LaneBatcher::Waiting*> LaneBatcher::take(std::size_t member) {
  std::vector<Waiting*> group;
  const std::size_t most = runner_.at_once(member);
  std::erase_if(waiting_, [&](Waiting* one) {
    const bool taken = one->member == member && group.size() < most;
    if (taken) group.push_back(one);
    return taken;
  });
  return group;
}

/// Steps a group of runs of this plan in the calling thread. The lock is released meanwhile.
void LaneBatcher::step(std::size_t member, const plan::CompiledPlan* alone,
                       std::unique_lock<std::mutex>& lock) {
  const std::vector<Waiting*> group = take(member);
  busy_ += group.size();
  lock.unlock();
  bool together = false;
  std::exception_ptr failure;
  try {
    std::vector<PendingRun> runs;
    for (Waiting* one : group) runs.push_back(std::move(*one->run));
    together = runner_.run(member, alone, runs);
    for (std::size_t i = 0; i < group.size(); ++i) *group[i]->run = std::move(runs[i]);
  } catch (...) {
    failure = std::current_exception();
  }
  lock.lock();
  busy_ -= group.size();
  for (Waiting* one : group) {
    one->ended = true;
    one->together = together;
    one->failure = failure;
  }
  changed_.notify_all();
}

}  // namespace stepwire::run
