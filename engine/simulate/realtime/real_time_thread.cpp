#include "engine/simulate/realtime/real_time_thread.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <pthread.h>
#include <sched.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <unistd.h>

#include <cerrno>
#include <charconv>
#include <cstdint>
#include <system_error>

namespace stepwire::realtime {

namespace {

constexpr std::size_t stack_bytes = 256 * 1024;

/// Writes to each page of the stack, which maps it.
[[gnu::noinline]] void touch_stack() {
  char stack[stack_bytes];
  volatile char* const bytes = stack;
  for (std::size_t i = 0; i < stack_bytes; i += 1024) bytes[i] = 0;
}

}  // namespace

std::optional<ThreadPolicy> parse_policy(std::string_view text) {
  if (text == "other") return ThreadPolicy{std::nullopt};
  if (!text.starts_with("fifo:")) return std::nullopt;
  text.remove_prefix(5);
  int priority = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), priority);
  const bool number = error == std::errc() && end == text.data() + text.size();
  if (!number || priority < 1 || priority > 99) return std::nullopt;
  return ThreadPolicy{priority};
}

std::string policy_text(const ThreadPolicy& policy) {
  return policy.fifo ? fmt::format("fifo:{}", *policy.fifo) : "other";
}

std::vector<int> allowed_cpus() {
  cpu_set_t set;
  std::vector<int> cpus;
  if (::sched_getaffinity(0, sizeof set, &set) != 0) return cpus;
  for (int cpu = 0; cpu < CPU_SETSIZE; ++cpu)
    if (CPU_ISSET(cpu, &set)) cpus.push_back(cpu);
  return cpus;
}

RealTimeThread::RealTimeThread(const ThreadPolicy& policy, std::optional<int> cpu) {
  touch_stack();
  lock_memory();
  ::prctl(PR_SET_TIMERSLACK, 1);  // in ns; needs no privilege
  keep_awake();
  if (cpu) bind_to(*cpu);
  schedule(policy);
}

RealTimeThread::~RealTimeThread() {
  if (latency_file_ >= 0) ::close(latency_file_);
  if (locked_) ::munlockall();
}

void RealTimeThread::refuse(const std::string& what, int reason, const std::string& cure) {
  refused_.push_back(fmt::format("{} ({}); {}", what, std::generic_category().message(reason), cure));
}

/// Locks the memory that is mapped now. Later mappings are excluded: the loop thread makes none, and other
/// threads may wait.
void RealTimeThread::lock_memory() {
  locked_ = ::mlockall(MCL_CURRENT) == 0;
  if (!locked_)
    refuse("memory is not locked, so a page may be missing at a step", errno,
           "CAP_IPC_LOCK or 'ulimit -l unlimited' allows it");
}

/// Opens the latency file; the kernel keeps the requested latency while it is open.
void RealTimeThread::keep_awake() {
  const std::int32_t microseconds = 0;
  latency_file_ = ::open("/dev/cpu_dma_latency", O_WRONLY | O_CLOEXEC);
  if (latency_file_ >= 0 && ::write(latency_file_, &microseconds, sizeof microseconds) > 0) return;
  refuse("processors may sleep deeply between steps", errno,
         "permission to write /dev/cpu_dma_latency prevents it");
}

void RealTimeThread::bind_to(int cpu) {
  cpu_set_t set;
  CPU_ZERO(&set);
  CPU_SET(static_cast<std::size_t>(cpu), &set);
  const int reason = ::pthread_setaffinity_np(::pthread_self(), sizeof set, &set);
  if (reason != 0)
    refuse(fmt::format("the thread is not bound to processor {}", cpu), reason,
           "'taskset -pc $$' tells which are allowed");
}

void RealTimeThread::schedule(const ThreadPolicy& policy) {
  sched_param parameter{};
  parameter.sched_priority = policy.fifo.value_or(0);
  const int reason =
      ::pthread_setschedparam(::pthread_self(), policy.fifo ? SCHED_FIFO : SCHED_OTHER, &parameter);
  if (reason != 0)
    refuse(fmt::format("the thread does not run with {}", policy_text(policy)), reason,
           fmt::format("CAP_SYS_NICE or 'ulimit -r {}' allows it", policy.fifo.value_or(0)));
}

std::string RealTimeThread::policy_in_force() {
  int policy = 0;
  sched_param parameter{};
  if (::pthread_getschedparam(::pthread_self(), &policy, &parameter) != 0) return "not known";
  if (policy == SCHED_FIFO) return policy_text({parameter.sched_priority});
  return policy == SCHED_OTHER ? "other" : fmt::format("policy {} of sched.h", policy);
}

}  // namespace stepwire::realtime
