#include "engine/app/python/watched_call.hpp"

#include <Python.h>

#include <chrono>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <optional>
#include <thread>

#include "engine/base/subprocess/process.hpp"

namespace stepwire::python {

namespace {

/// Work on its own thread.
class Work {
 public:
  Work(const std::function<void(std::atomic<bool>&)>& work) : thread_([this, &work] { carry_out(work); }) {}

  bool is_done_within(std::chrono::milliseconds time) {
    std::unique_lock lock(mutex_);
    return changed_.wait_for(lock, time, [this] { return done_; });
  }
  void interrupt() { interrupt_ = true; }
  /// Joins the thread and rethrows the exception of the work.
  void finish() {
    thread_.join();
    if (thrown_) std::rethrow_exception(thrown_);
  }

 private:
  void carry_out(const std::function<void(std::atomic<bool>&)>& work) {
    try {
      work(interrupt_);
    } catch (...) {
      thrown_ = std::current_exception();
    }
    const std::lock_guard lock(mutex_);
    done_ = true;
    changed_.notify_one();
  }

  std::atomic<bool> interrupt_ = false;
  std::mutex mutex_;
  std::condition_variable changed_;
  bool done_ = false;
  std::exception_ptr thrown_;
  std::thread thread_;
};

/// During its lifetime, child processes on which a call waits are terminated.
class StoppedPrograms {
 public:
  StoppedPrograms() { subprocess::processes_stop() = true; }
  ~StoppedPrograms() { subprocess::processes_stop() = false; }
};

}  // namespace

void call_watched(const std::function<void(std::atomic<bool>&)>& work, Raised& raised) {
  constexpr std::chrono::milliseconds between_looks(50);
  std::optional<StoppedPrograms> stopped;
  const Unlocked unlocked;
  Work going_on(work);
  while (!going_on.is_done_within(between_looks)) {
    const Lock lock;
    if (PyErr_CheckSignals() == 0) continue;
    raised.keep();
    going_on.interrupt();
    stopped.emplace();
  }
  going_on.finish();
}

void call_checked(const std::function<void()>& work) {
  Raised raised;
  call_watched([&](std::atomic<bool>&) { work(); }, raised);
  raised.throw_if_any();
}

}  // namespace stepwire::python
