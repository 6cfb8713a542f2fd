#include "engine/simulate/guard/running_guard.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>

#include "engine/base/driver/open_device.hpp"
#include "engine/base/io/environment_error.hpp"

namespace stepwire::guard {

namespace {

constexpr std::int64_t longest_start = 10'000'000'000, longest_end = 2'000'000'000;  // [ns]

/// Becomes the guard, in a session of its own that a terminal's signals do not reach.
[[noreturn]] void become_guard(const std::string& program, int memory, int life) {
  constexpr int first = 3;
  ::setsid();
  const int moved_memory = ::fcntl(memory, F_DUPFD, first + 2),
            moved_life = ::fcntl(life, F_DUPFD, first + 2);
  ::dup2(moved_memory, first);
  ::dup2(moved_life, first + 1);
  ::close_range(first + 2, ~0u, 0);
  ::execl(program.c_str(), "stepwire_guard", "3", "4", nullptr);
  ::_exit(127);
}

}  // namespace

RunningGuard::RunningGuard(const GuardCall& call)
    : link_(call.limits.inputs.size(), call.limits.outputs.size(), bytes_of(call)), late_(call.limits.late) {
  spawn();
  await(GuardState::starting, longest_start);
  if (link_.state() == GuardState::running) return;
  const std::string reason = link_.reason();
  throw io::EnvironmentError(reason.empty() ? "the guard has not started; without it: guard: false" : reason);
}

RunningGuard::~RunningGuard() {
  finish();
}

void RunningGuard::spawn() {
  const std::string program = driver::program_file("stepwire_guard");
  std::array<int, 2> ends{-1, -1};
  if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0)
    throw io::EnvironmentError(fmt::format("the guard cannot be started: {}", std::strerror(errno)));
  life_ = io::Descriptor(ends[0]);
  const io::Descriptor there(ends[1]);
  process_ = ::fork();
  if (process_ == 0) become_guard(program, link_.descriptor(), there.number());
  if (process_ < 0)
    throw io::EnvironmentError(fmt::format("the guard cannot be started: {}", std::strerror(errno)));
}

/// Waits until the state is beyond `worst`, the guard has ended, or the limit has passed.
void RunningGuard::await(GuardState worst, std::int64_t limit) {
  const std::int64_t end = monotonic() + limit;
  while (link_.state() <= worst && monotonic() < end) {
    pollfd look{life_.number(), 0, 0};
    if (::poll(&look, 1, 1) > 0) return;
  }
}

/// A guard whose end of life is closed has ended. One that has not turned for the time that a loop may be
/// late is stopped, or does not get the processor.
bool RunningGuard::is_well() noexcept {
  if (gone_ || link_.state() != GuardState::running) return false;
  const std::uint64_t turns = link_.turns();
  const std::int64_t time = monotonic();
  if (turns != turns_ || turned_ == 0) {
    turns_ = turns;
    turned_ = time;
  } else if (time - turned_ > late_) {
    gone_ = true;
  }
  pollfd look{life_.number(), 0, 0};
  gone_ = gone_ || ::poll(&look, 1, 0) > 0;
  return !gone_;
}

bool RunningGuard::inputs(double* values) noexcept {
  return is_well() && link_.inputs().get(values);
}

bool RunningGuard::command(const double* values) noexcept {
  link_.commands().put(values);
  link_.beat(GuardRequest::command);
  return link_.state() == GuardState::running;
}

std::string RunningGuard::finish() {
  if (process_ < 0) return "";
  link_.beat(GuardRequest::finish);
  await(GuardState::failed, longest_end);
  life_.close();
  if (link_.state() != GuardState::ended) ::kill(process_, SIGKILL);
  ::waitpid(process_, nullptr, 0);
  process_ = -1;
  return link_.reports();
}

std::string RunningGuard::trouble() const {
  if (gone_ && link_.state() == GuardState::running)
    return "the guard has ended or does not get the processor; the loop has set the outputs to their safe "
           "values";
  return link_.state() == GuardState::running ? "" : link_.reason();
}

}  // namespace stepwire::guard
