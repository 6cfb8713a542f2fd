#include "engine/simulate/guard/running_guard.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <pthread.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <utility>

#include "engine/base/driver/open_device.hpp"
#include "engine/base/io/environment_error.hpp"

namespace stepwire::guard {

namespace {

constexpr std::int64_t longest_start = 10'000'000'000, longest_end = 2'000'000'000,
                       longest_keep = 2'500'000'000;  // [ns]

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

RunningGuard::Shared::Shared(GuardCall of)
    : call(std::move(of)), link(call.limits.inputs.size(), call.limits.outputs.size(), bytes_of(call)) {}

RunningGuard::RunningGuard(GuardCall call)
    : shared_(std::make_shared<Shared>(std::move(call))),
      call_(shared_->call),
      link_(shared_->link),
      inputs_(call_.limits.inputs.size(), 0.0),
      read_(inputs_) {
  spawn();
}

void RunningGuard::start(const std::atomic<bool>* interrupt) {
  link_.beat(GuardRequest::start);
  await(GuardState::starting, longest_start + call_.wait, interrupt);
  if (link_.state() != GuardState::running) {
    const bool was_interrupted = interrupt && *interrupt;
    const std::string reason = why_not_started();
    finish();
    if (was_interrupted) return;
    throw io::EnvironmentError(reason);
  }
  process_watch_ = std::thread([shared = shared_] { watch_process(*shared); });
  sched_param parameter{};
  parameter.sched_priority = call_.priority;
  if (call_.priority > 0) ::pthread_setschedparam(process_watch_.native_handle(), SCHED_FIFO, &parameter);
}

std::string RunningGuard::names_of_devices() const {
  std::vector<std::string> names;
  for (const DeviceSettings& one : call_.devices) names.push_back(one.name);
  return fmt::format("{}", fmt::join(names, ", "));
}

std::string RunningGuard::end_text(const siginfo_t& change) const {
  if (change.si_pid == 0) return "the guard has not read the devices in time";
  if (change.si_code == CLD_EXITED)
    return fmt::format("the guard has ended with exit code {}", change.si_status);
  return fmt::format("the guard was {} by signal {} ({})",
                     change.si_code == CLD_STOPPED ? "stopped" : "ended", change.si_status,
                     ::strsignal(change.si_status));
}

std::string RunningGuard::why_not_started() const {
  if (link_.state() == GuardState::failed) return link_.reason();
  const auto change = end_of(process_);
  if (!change)
    return fmt::format("the guard does not come to an end of the start of {}; a driver there does not return",
                       names_of_devices());
  return fmt::format("{} while it started {}", end_text(*change), names_of_devices());
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
  process_ = shared_->process = ::fork();
  if (process_ == 0) become_guard(program, link_.descriptor(), there.number());
  if (process_ < 0)
    throw io::EnvironmentError(fmt::format("the guard cannot be started: {}", std::strerror(errno)));
}

/// Waits until the state is beyond `worst`, the guard has ended, or the limit has passed.
void RunningGuard::await(GuardState worst, std::int64_t limit, const std::atomic<bool>* interrupt) {
  const std::int64_t end = monotonic() + limit;
  while (link_.state() <= worst && monotonic() < end && !(interrupt && *interrupt) && !end_of(process_))
    ::usleep(500);
}

std::optional<siginfo_t> RunningGuard::end_of(pid_t process) noexcept {
  siginfo_t change{};
  const int result = ::waitid(P_PID, static_cast<id_t>(process), &change, WEXITED | WNOHANG | WNOWAIT);
  if (result == 0 && change.si_pid == 0) return std::nullopt;
  return change;
}

void RunningGuard::watch_process(Shared& shared) noexcept {
  siginfo_t change{};
  int result = -1;
  do {
    result = ::waitid(P_PID, static_cast<id_t>(shared.process), &change, WEXITED | WSTOPPED | WNOWAIT);
  } while (result != 0 && errno == EINTR);
  if (result == 0 && !shared.finishing) rescue(shared, change);
  shared.watched = true;
}

/// The kill prevents a stopped guard from writing later; an exclusive device opens once it has ended.
void RunningGuard::rescue(Shared& shared, const siginfo_t& change) noexcept {
  if (!shared.late) shared.change = change;
  shared.gone = true;
  ::kill(shared.process, SIGKILL);
  for (int looks = 0; looks < 2000 && !end_of(shared.process); ++looks) ::usleep(50);
  const std::string failures = set_safe(shared.call);  // allocates, but the loop ends
  if (failures.empty()) shared.link.note_safe();
}

/// Inputs are read three quarters of a period after a command. The largest age of half a period less than the
/// loop may be late lets the outputs become safe within two periods, whenever the guard has lost its
/// processor. The kill wakes the thread that sets the safe values.
bool RunningGuard::is_well() noexcept {
  if (shared_->gone || link_.state() != GuardState::running) return false;
  if (monotonic() - link_.read_at() <= call_.limits.late - call_.limits.period / 2) return true;
  shared_->late = true;
  shared_->gone = true;
  ::kill(process_, SIGKILL);
  return false;
}

bool RunningGuard::inputs(double* values) noexcept {
  if (!is_well()) return false;
  if (link_.inputs().get(read_.data())) std::swap(inputs_, read_);
  std::ranges::copy(inputs_, values);
  return true;
}

bool RunningGuard::command(const double* values) noexcept {
  if (shared_->gone) return false;
  link_.commands().put(values);
  link_.beat(GuardRequest::command);
  return link_.state() == GuardState::running;
}

/// Waits for the keeper, which sets the safe values now.
void RunningGuard::await_safe() const {
  const std::int64_t end = monotonic() + longest_keep;
  while (!link_.is_safe() && monotonic() < end) ::usleep(500);
}

/// Joins the thread, or leaves it in a driver that does not return.
void RunningGuard::end_watch() {
  if (!process_watch_.joinable()) return;
  const std::int64_t end = monotonic() + longest_start;
  while (!shared_->watched && monotonic() < end) ::usleep(500);
  shared_->watched ? process_watch_.join() : process_watch_.detach();
}

/// Waits for the end of the guard's process, and kills one that does not end.
void RunningGuard::end_process() {
  const std::int64_t end = monotonic() + longest_end;
  while (!end_of(process_) && monotonic() < end) ::usleep(500);
  ::kill(process_, SIGKILL);
}

std::string RunningGuard::finish() {
  if (process_ < 0) return "";
  shared_->finishing = !shared_->gone;
  link_.beat(GuardRequest::finish);
  if (!shared_->gone) await(GuardState::failed, longest_end);
  life_.close();
  finished_ = link_.state() == GuardState::ended || link_.state() == GuardState::failed;
  overdue_ = !finished_ && !end_of(process_);
  if (!finished_) ::kill(process_, SIGKILL);
  end_process();
  end_watch();
  ::waitpid(process_, nullptr, 0);
  if (!finished_ && !shared_->gone) await_safe();
  process_ = -1;
  return link_.reports();
}

std::string RunningGuard::text_of_unfinished() const {
  const std::string end = overdue_
                              ? fmt::format("was killed since a driver of {} has not returned within {} s",
                                            names_of_devices(), longest_end / 1'000'000'000)
                              : fmt::format("has ended in a driver of {}", names_of_devices());
  return fmt::format("the guard {} at the end of the loop; {}", end,
                     link_.is_safe() ? "the outputs are at their safe values"
                                     : "the outputs may not be at their safe values");
}

std::string RunningGuard::trouble() const {
  if (shared_->gone)
    return fmt::format("{}; devices are {}; {}", end_text(shared_->change), names_of_devices(),
                       link_.is_safe()    ? "the outputs are at their safe values"
                       : shared_->watched ? "the outputs may not be at their safe values"
                                          : "a driver there does not return, and the outputs may not be at "
                                            "their safe values");
  if (process_ < 0 && !finished_) return text_of_unfinished();
  return link_.state() == GuardState::running ? "" : link_.reason();
}

}  // namespace stepwire::guard
