#include "engine/simulate/guard/keeper.hpp"

#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <exception>

#include "engine/base/io/environment_error.hpp"
#include "engine/simulate/guard/guard_call.hpp"

namespace stepwire::guard {

namespace {

/// Waits until all other ends of a pipe or socket are closed. What comes through it is nothing to read.
void await_end(int descriptor) {
  pollfd look{descriptor, 0, 0};
  while (::poll(&look, 1, -1) < 0 && errno == EINTR) {
  }
}

[[noreturn]] void keep(Link& link, int guard, int life) {
  ::prctl(PR_SET_NAME, "stepwire_keeper");
  const GuardCall call = guard_call(link.call());
  become_prompt(call.priority);
  await_end(guard);
  await_end(life);
  if (!link.is_safe()) {
    set_safe(call);
    std::fputs(
        "the loop and its guard were ended; a third process has set all outputs to their safe values\n",
        stderr);
  }
  ::_exit(0);
}

}  // namespace

void start_keeper(Link& link, int life) {
  std::array<int, 2> ends{-1, -1};
  if (::pipe2(ends.data(), O_CLOEXEC) != 0) throw io::EnvironmentError("the guard has no pipe");
  const pid_t keeper = ::fork();
  if (keeper < 0) throw io::EnvironmentError("the guard cannot start its keeper");
  ::close(ends[keeper == 0 ? 1 : 0]);  // the guard holds the end to write until it ends
  if (keeper == 0) keep(link, ends[0], life);
}

}  // namespace stepwire::guard
