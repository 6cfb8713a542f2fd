#include "engine/simulate/guard/keeper.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <string>
#include <string_view>

#include "engine/base/io/environment_error.hpp"
#include "engine/simulate/guard/guard_call.hpp"

namespace stepwire::guard {

namespace {

constexpr unsigned longest_open = 10;              // Limit of open and start [s].
constexpr unsigned longest_call = 2;               // Limit of another call of a driver [s].
constexpr int look_time = 20;                      // Time between two looks at the guard [ms].
constexpr std::int64_t beyond_late = 100'000'000;  // Time of a live guard without a read, beyond `late` [ns].
constexpr std::int64_t longest_safe = 2'500'000'000;    // of a driver's safe in the guard [ns]
constexpr std::int64_t between_tries = 1'000'000;       // between two tries [ns]
constexpr std::int64_t longest_tries = 10'000'000'000;  // [ns]

std::array<char, 256> late_text{};  // for the signal handler

/// Processes of a guarded loop. The descriptors are of the processes themselves, so that no others are meant.
struct Watched {
  int guard = -1, loop = -1;
  int life = -1;  ///< pipe whose other end the guard has
};

/// Waits until all other ends of a pipe are closed, at most for this time [ms]; -1: without limit. Nothing is
/// written to the pipe.
bool has_ended(int pipe, int time) {
  pollfd look{pipe, 0, 0};
  int result = 0;
  while ((result = ::poll(&look, 1, time)) < 0 && errno == EINTR) {
  }
  return result != 0;
}

/// Time in which the guard has read no devices though it should.
class Silence {
 public:
  Silence(const Link& link, std::int64_t late) : link_(link), longest_live_(late + beyond_late) {}

  /// Returns true once it is too long. Is called every look_time.
  bool is_too_long() {
    constexpr std::int64_t most = 2 * std::int64_t{look_time} * 1'000'000;
    const std::int64_t now = monotonic(), read = link_.read_at();
    const Outputs outputs = link_.outputs();
    const bool goes_on = read != read_ || outputs != outputs_ || outputs == Outputs::safe || link_.is_safe();
    time_ = goes_on ? 0 : time_ + std::min(now - last_, most);
    last_ = now;
    read_ = read;
    outputs_ = outputs;
    return time_ > (outputs == Outputs::live ? longest_live_ : longest_safe);
  }
  double seconds() const { return 1e-9 * static_cast<double>(time_); }

 private:
  const Link& link_;
  std::int64_t longest_live_, time_ = 0, read_ = 0, last_ = 0;
  Outputs outputs_ = Outputs::safe;
};

/// Waits for the end of the guard, and kills one that does not run. Returns how it has ended.
std::string await_end(const Link& link, const Watched& watched, std::int64_t late) {
  Silence silence(link, late);
  while (!has_ended(watched.life, look_time)) {
    if (!silence.is_too_long()) continue;
    ::syscall(SYS_pidfd_send_signal, watched.guard, SIGKILL, nullptr, 0);
    has_ended(watched.life, -1);
    return fmt::format("the guard was ended since it did not run for {:.2g} s", silence.seconds());
  }
  return "the guard was ended";
}

/// Waits at most this time [ns]. Returns true once the outputs are safe.
bool becomes_safe(const Link& link, std::int64_t time) {
  const std::int64_t end = monotonic() + time;
  while (!link.is_safe() && monotonic() < end) ::usleep(50);
  return link.is_safe();
}

void end_by_time(int) {
  [[maybe_unused]] const auto size = ::write(STDERR_FILENO, late_text.data(), std::strlen(late_text.data()));
  ::_exit(3);
}

/// Ends the process after a time, unless the next call begins before.
void limit_call(const std::string& device, const char* function) {
  ::alarm(0);
  std::snprintf(late_text.data(), late_text.size(),
                "the driver of %s does not return from %s, and outputs may not be at their safe values\n",
                device.c_str(), function);
  const std::string_view name = function;
  ::alarm(name == "open" || name == "start" ? longest_open : longest_call);
}

/// Kills the loop if it is stopped. `process` is its descriptor, so that no other process is meant.
void end_stopped_loop(const Link& link, int process) {
  std::ifstream file("/proc/" + std::to_string(link.loop()) + "/stat");
  std::string stat;
  std::getline(file, stat);
  const std::size_t state = stat.rfind(") ");
  if (state != std::string::npos && stat.compare(state + 2, 1, "T") == 0)
    ::syscall(SYS_pidfd_send_signal, process, SIGKILL, nullptr, 0);
}

/// Tries again while the loop has an exclusive device open.
void set_safe_in_place_of_loop(Link& link, const GuardCall& call, int loop, const std::string& why) {
  const std::int64_t end = monotonic() + longest_tries;
  std::string failures = set_safe(call, limit_call);
  while (!failures.empty() && monotonic() < end) {
    if (becomes_safe(link, between_tries)) return;
    end_stopped_loop(link, loop);
    failures = set_safe(call, limit_call);
  }
  ::alarm(0);
  if (failures.empty()) {
    link.note_safe();
    std::fprintf(stderr, "%s, and a third process has set all outputs to their safe values\n", why.c_str());
  } else {
    std::fprintf(stderr, "%s, and outputs are not at their safe values: %s\n", why.c_str(), failures.c_str());
  }
}

[[noreturn]] void keep(Link& link, const Watched& watched) {
  ::prctl(PR_SET_NAME, "stepwire_keeper");
  const GuardCall call = guard_call(link.call());
  become_prompt(call.priority);
  const std::string why = await_end(link, watched, call.limits.late);
  std::signal(SIGALRM, end_by_time);
  if (!becomes_safe(link, call.limits.period / 2)) set_safe_in_place_of_loop(link, call, watched.loop, why);
  ::_exit(0);
}

}  // namespace

pid_t start_keeper(Link& link) {
  std::array<int, 2> ends{-1, -1};
  if (::pipe2(ends.data(), O_CLOEXEC) != 0) throw io::EnvironmentError("the guard has no pipe");
  const auto descriptor = [](pid_t process) {
    return static_cast<int>(::syscall(SYS_pidfd_open, process, 0));
  };
  const Watched watched{descriptor(::getpid()), descriptor(link.loop()), ends[0]};
  const pid_t keeper = ::fork();
  if (keeper < 0) throw io::EnvironmentError("the guard cannot start its keeper");
  ::close(ends[keeper == 0 ? 1 : 0]);  // the guard holds the end to write until it ends
  if (keeper == 0) keep(link, watched);
  return keeper;
}

bool is_lost(pid_t keeper) noexcept {
  siginfo_t change{};
  const int result =
      ::waitid(P_PID, static_cast<id_t>(keeper), &change, WEXITED | WSTOPPED | WNOHANG | WNOWAIT);
  return result != 0 || change.si_pid != 0;
}

}  // namespace stepwire::guard
