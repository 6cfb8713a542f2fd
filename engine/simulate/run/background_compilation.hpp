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

/// Gets code beside the runs that will use it, once it is worth it: what earlier calls have kept nearly at
/// once, and what has to be compiled when twice as long as that takes is left to do.
class BackgroundCompilation {
 public:
  /// What is known before the first tick.
  struct Prospect {
    double seconds = 0.0;         ///< that it takes to compile all; 0: there is nothing to get
    std::optional<double> ticks;  ///< of all runs; nothing: as many are expected as have been done
    double patience = 0.1;        ///< [s] after which it is known how fast the runs are
  };
  /// Gets all code within these limits. False: not all of it was kept.
  using Work = std::function<bool(const plan::CodeLimits&)>;

  /// `work` is called by at most one thread at a time.
  BackgroundCompilation(const Prospect& prospect, Work work);

  /// Gets it now, in this thread; done() does nothing any more.
  void at_once();
  /// Notes that so many more ticks of all are done. From any thread.
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
  std::mutex mutex_;     ///< of the thread
  std::jthread thread_;  ///< last: it uses the others
};

}  // namespace stepwire::run
