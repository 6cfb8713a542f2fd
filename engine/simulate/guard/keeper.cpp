#include "engine/simulate/guard/keeper.hpp"

#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

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

constexpr unsigned longest_open = 10, longest_call = 2;  // of open and start, of another call of a driver [s]
constexpr std::int64_t between_tries = 1'000'000;        // between two tries [ns]
constexpr std::int64_t longest_tries = 10'000'000'000;   // [ns]

std::array<char, 256> late_text{};  // for the signal handler

/// Waits until all other ends of a pipe are closed. Nothing is written to it.
void await_end(int descriptor) {
  pollfd look{descriptor, 0, 0};
  while (::poll(&look, 1, -1) < 0 && errno == EINTR) {
  }
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
void set_safe_in_place_of_loop(Link& link, const GuardCall& call, int loop) {
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
    std::fputs("the guard was ended, and a third process has set all outputs to their safe values\n", stderr);
  } else {
    std::fprintf(stderr, "the guard was ended, and outputs are not at their safe values: %s\n",
                 failures.c_str());
  }
}

[[noreturn]] void keep(Link& link, int guard, int loop) {
  ::prctl(PR_SET_NAME, "stepwire_keeper");
  const GuardCall call = guard_call(link.call());
  become_prompt(call.priority);
  await_end(guard);
  std::signal(SIGALRM, end_by_time);
  if (!becomes_safe(link, call.limits.period / 2)) set_safe_in_place_of_loop(link, call, loop);
  ::_exit(0);
}

}  // namespace

pid_t start_keeper(Link& link) {
  std::array<int, 2> ends{-1, -1};
  if (::pipe2(ends.data(), O_CLOEXEC) != 0) throw io::EnvironmentError("the guard has no pipe");
  const auto loop = static_cast<int>(::syscall(SYS_pidfd_open, link.loop(), 0));
  const pid_t keeper = ::fork();
  if (keeper < 0) throw io::EnvironmentError("the guard cannot start its keeper");
  ::close(ends[keeper == 0 ? 1 : 0]);  // the guard holds the end to write until it ends
  if (keeper == 0) keep(link, ends[0], loop);
  return keeper;
}

bool is_lost(pid_t keeper) noexcept {
  siginfo_t change{};
  const int result =
      ::waitid(P_PID, static_cast<id_t>(keeper), &change, WEXITED | WSTOPPED | WNOHANG | WNOWAIT);
  return result != 0 || change.si_pid != 0;
}

}  // namespace stepwire::guard
