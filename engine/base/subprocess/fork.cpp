#include "engine/base/subprocess/fork.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>

namespace stepwire::subprocess {

namespace {

void close_all_but(std::vector<int> kept) {
  std::ranges::sort(kept);
  unsigned first = 3;
  for (const int one : kept) {
    const auto number = static_cast<unsigned>(one);
    if (number > first) ::close_range(first, number - 1, 0);
    first = std::max(first, number + 1);
  }
  ::close_range(first, ~0u, 0);
}

/// Requests SIGKILL when the other process closes its end of a pipe, which its exit does as well.
/// PR_SET_PDEATHSIG would follow the creating thread instead of the process.
void end_with(int other) {
  ::fcntl(other, F_SETOWN, ::getpid());
  ::fcntl(other, F_SETSIG, SIGKILL);
  ::fcntl(other, F_SETFL, O_ASYNC);
  pollfd look{other, 0, 0};
  if (::poll(&look, 1, 0) > 0) ::_exit(1);  // the other process has already ended
}

void leave_other_process(const std::vector<int>& kept) {
  ::setpgid(0, 0);  // a new group, so that processes of foreign code can be killed with this one
  // Skips the exit handlers of the parent if foreign code calls exit().
  ::on_exit([](int status, void*) { ::_exit(status); }, nullptr);
  for (const int signal : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT, SIGTERM, SIGPIPE, SIGXFSZ})
    std::signal(signal, SIG_DFL);
  for (const int signal : {SIGINT, SIGHUP, SIGQUIT}) std::signal(signal, SIG_IGN);
  close_all_but(kept);
}

}  // namespace

std::mutex& loader_mutex() {
  static std::mutex mutex;
  return mutex;
}

Fork::Fork(const std::function<void()>& work, std::vector<int> kept) {
  std::array<int, 2> ends{-1, -1};
  if (::pipe2(ends.data(), O_CLOEXEC) != 0) return;
  io::Descriptor there(ends[0]);
  life_ = io::Descriptor(ends[1]);
  std::unique_lock lock(loader_mutex());
  id_ = ::fork();
  lock.unlock();
  if (id_ > 0) ::setpgid(id_, id_);  // in both processes, since either may run first
  if (id_ != 0) return;
  kept.push_back(there.number());
  leave_other_process(kept);
  end_with(there.number());
  work();
  ::_exit(0);
}

Fork::~Fork() {
  if (started()) end();
}

bool Fork::has_ended() {
  if (!ended_) look(WNOHANG);
  return ended_;
}

void Fork::wait() {
  while (!ended_) look(0);
}

/// Checks or waits for the end. It kills the group before it reaps the process, while the group number is
/// still valid.
void Fork::look(int how) {
  siginfo_t info{};
  if (::waitid(P_PID, static_cast<id_t>(id_), &info, WEXITED | WNOWAIT | how) != 0) {
    ended_ = errno == ECHILD;  // no status is available where SIGCHLD is ignored
    return;
  }
  if (info.si_pid != id_) return;
  ::kill(-id_, SIGKILL);
  ended_ = ::waitpid(id_, &status_, 0) == id_;
}

void Fork::end() {
  if (!ended_) ::kill(id_, SIGKILL);
  wait();
}

int Fork::status() const {
  return WIFEXITED(status_) ? WEXITSTATUS(status_) : 0;
}

std::string Fork::ending() const {
  if (WIFSIGNALED(status_))
    return fmt::format("was ended by signal {} ({})", WTERMSIG(status_), ::strsignal(WTERMSIG(status_)));
  return fmt::format("has ended itself with status {}", status());
}

}  // namespace stepwire::subprocess
