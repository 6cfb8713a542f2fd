#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace stepwire::realtime {

/// How the loop thread is scheduled: SCHED_FIFO with a priority of 1 to 99, or as every other thread.
struct ThreadPolicy {
  std::optional<int> fifo = 80;

  bool operator==(const ThreadPolicy&) const = default;
};

/// Reads "fifo:80" or "other"; nothing if it is neither.
std::optional<ThreadPolicy> parse_policy(std::string_view text);
/// "fifo:80", "other".
std::string policy_text(const ThreadPolicy& policy);

/// The processors on which this process may run.
std::vector<int> allowed_cpus();

/// Makes a real-time thread of the one that creates it, as far as it is allowed: memory locked, its stack
/// touched, timers exact to 1 ns, processors kept from sleeping deeply (0 us in /dev/cpu_dma_latency), bound
/// to one processor where one is given, scheduled as asked. Memory and processors are let go at the end; the
/// thread stays as it is.
class RealTimeThread {
 public:
  RealTimeThread(const ThreadPolicy& policy, std::optional<int> cpu);
  ~RealTimeThread();
  RealTimeThread(const RealTimeThread&) = delete;
  RealTimeThread& operator=(const RealTimeThread&) = delete;

  /// What was not allowed, with the reason, what follows from it, and what would allow it; one line each.
  const std::vector<std::string>& refused() const { return refused_; }
  /// What is really in force, as the system says: "fifo:80", "other".
  static std::string policy_in_force();

 private:
  void lock_memory();
  void keep_awake();
  void bind_to(int cpu);
  void schedule(const ThreadPolicy& policy);
  void refuse(const std::string& what, int reason, const std::string& cure);

  std::vector<std::string> refused_;
  bool locked_ = false;
  int latency_file_ = -1;
};

}  // namespace stepwire::realtime
