#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace stepwire::realtime {

/// Scheduling of the loop thread: SCHED_FIFO with a priority of 1 to 99, or the default policy.
struct ThreadPolicy {
  std::optional<int> fifo = 80;

  bool operator==(const ThreadPolicy&) const = default;
};

/// Parses "fifo:80" or "other"; std::nullopt for any other text.
std::optional<ThreadPolicy> parse_policy(std::string_view text);
/// Returns "fifo:80" or "other".
std::string policy_text(const ThreadPolicy& policy);

/// Returns the processors on which this process may run.
std::vector<int> allowed_cpus();

/// Makes the calling thread a real-time thread, as far as permissions allow.
///
/// Its memory is locked, its stack mapped, and its timers are exact to 1 ns. Processors are kept out of deep
/// sleep (0 us in /dev/cpu_dma_latency). It is bound to a processor if one is given, and scheduled by the
/// policy. The destructor releases memory and processors; the thread's settings stay.
class RealTimeThread {
 public:
  RealTimeThread(const ThreadPolicy& policy, std::optional<int> cpu);
  ~RealTimeThread();
  RealTimeThread(const RealTimeThread&) = delete;
  RealTimeThread& operator=(const RealTimeThread&) = delete;

  /// Returns a line for each refused setting, with the reason, the consequence and the cure.
  const std::vector<std::string>& refused() const { return refused_; }
  /// Returns the policy that the system reports for this thread: "fifo:80" or "other".
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
