#include "engine/base/subprocess/isolated.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <new>

#include "engine/base/subprocess/fork.hpp"
#include "engine/base/subprocess/process.hpp"

namespace stepwire::subprocess {

namespace {

using Clock = std::chrono::steady_clock;

constexpr int milliseconds_per_look = 20;
constexpr int out_of_memory = 117, has_thrown = 118;  // exit statuses with this meaning

/// Returns the address space of this process in bytes; 0 if unknown.
rlim_t addressed_bytes() {
  rlim_t pages = 0;
  std::ifstream("/proc/self/statm") >> pages;
  return pages * static_cast<rlim_t>(::sysconf(_SC_PAGESIZE));
}

void bound(int resource, rlim_t most) {
  rlimit now{};
  if (::getrlimit(resource, &now) != 0) return;
  now.rlim_cur = std::min(most, now.rlim_max);
  ::setrlimit(resource, &now);
}

void close_streams() {
  const int nothing = ::open("/dev/null", O_RDWR);
  for (int stream = 0; stream < 3; ++stream) ::dup2(nothing, stream);
  if (nothing > 2) ::close(nothing);
}

/// Runs the function in the child process with all limits set.
void work(const std::function<void(int)>& function, int output, std::size_t memory) {
  close_streams();
  bound(RLIMIT_CORE, 0);
  bound(RLIMIT_FSIZE, memory);
  if (const rlim_t now = addressed_bytes(); now > 0) bound(RLIMIT_AS, now + memory);
  try {
    function(output);
  } catch (const std::bad_alloc&) {
    ::_exit(out_of_memory);
  } catch (...) {
    ::_exit(has_thrown);
  }
}

/// Makes a pipe whose second end the child holds; the end of the child closes it.
std::array<io::Descriptor, 2> sign_of_life() {
  std::array<int, 2> ends{-1, -1};
  if (::pipe2(ends.data(), O_CLOEXEC) != 0) throw IsolationError("gets no pipe from the system");
  return {io::Descriptor(ends[0]), io::Descriptor(ends[1])};
}

/// Waits for the end of the child. A closed pipe ends the wait at once; where a grandchild still holds it,
/// polling detects the end.
void await_end(Fork& fork, int sign, std::chrono::milliseconds limit) {
  const Clock::time_point end = Clock::now() + limit;
  pollfd wait{sign, 0, 0};
  while (!fork.has_ended()) {
    if (processes_stop()) throw ProcessStopped("reading was stopped");
    if (Clock::now() > end)
      throw IsolationError(
          "does not come to an end and was ended; STEPWIRE_HELPER_LIMIT allows more seconds");
    ::poll(&wait, 1, milliseconds_per_look);
  }
}

void require_success(const Fork& fork, std::size_t memory) {
  if (fork.status() == out_of_memory)
    throw IsolationError(fmt::format("takes more than {} MB of memory", memory >> 20));
  if (!fork.succeeded()) throw IsolationError(fork.ending());
}

}  // namespace

io::Descriptor call_isolated(const std::function<void(int output)>& function, const IsolationBounds& bounds) {
  io::Descriptor output(::memfd_create("stepwire", MFD_CLOEXEC));
  if (!output.open()) throw IsolationError("gets no memory from the system");
  auto [here, there] = sign_of_life();
  Fork fork([&] { work(function, output.number(), bounds.memory); }, {output.number(), there.number()});
  if (!fork.started()) throw IsolationError("gets no process from the system");
  there.close();
  await_end(fork, here.number(), bounds.limit);
  require_success(fork, bounds.memory);
  ::lseek(output.number(), 0, SEEK_SET);
  return output;
}

}  // namespace stepwire::subprocess
