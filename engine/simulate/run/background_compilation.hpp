#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <functional>
#include <mutex>
#include <optional>
#include <stop_token>
#include <thread>

#include "engine/model/plan/compiled_plan.hpp"

namespace stepwire::run {

/// Plan of some runs.
struct PlanOfRuns {
  const plan::Plan* plan;
  plan::RunDifferences differences{};
  std::optional<std::size_t> runs{};  ///< Number of runs; std::nullopt if unknown.
};

/// Compiles the code of runs on a second thread while these runs proceed interpreted.
///
/// The policy has two thresholds on the estimated remaining time. Above twice the cost of a cache lookup,
/// code that earlier calls have cached is loaded. Above twice the compile time, the missing code is compiled.
class BackgroundCompilation {
 public:
  /// Estimates that are available before the first tick.
  struct Prospect {
    double seconds = 0.0;         ///< Compile time of all code; 0: no compilation.
    std::optional<double> ticks;  ///< Ticks of all runs; std::nullopt: twice the done ones.
    double patience = 0.1;        ///< Time [s] until the speed of the runs is measurable.
  };
  /// Compiles or loads all code within these limits. Returns false if some code was not in the cache.
  using Work = std::function<bool(const plan::CodeLimits&)>;

  /// `work` is called by at most one thread at a time.
  BackgroundCompilation(const Prospect& prospect, Work work);

  /// Compiles at once, in the calling thread. Later calls of done() have no effect.
  void at_once();
  /// Adds `ticks` to the number of done ticks of all runs. Thread-safe.
  void done(std::int64_t ticks);

 private:
  using Clock = std::chrono::steady_clock;
  enum class Stage : int { idle, looking, looked, ended };

  bool is_worth(const Prospect& prospect, double done) const;
  void look(const std::stop_token& stop);
  template <class Task>
  void beside(const Task& task);

  Prospect compilation_, look_;
  Work work_;
  Clock::time_point start_ = Clock::now();
  std::atomic<std::int64_t> done_ = 0;
  std::atomic<Stage> stage_;
  std::mutex mutex_;     ///< guards thread_
  std::jthread thread_;  ///< last member: its thread uses the others
};

}  // namespace stepwire::run
