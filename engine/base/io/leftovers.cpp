#include "engine/base/io/leftovers.hpp"

#include <unistd.h>

#include <array>
#include <atomic>
#include <climits>
#include <csignal>
#include <cstring>
#include <ctime>

#include "engine/base/io/group_beginning.hpp"

namespace stepwire::io {

namespace {

enum class State { free, taken, ready };

struct PathPlace {
  std::atomic<State> state = State::free;
  bool folder = false;
  std::array<char, PATH_MAX> path;
};

// Fixed arrays of atomics, since a signal handler must not lock or allocate. They bound the number of files
// and groups open at a time.
std::array<PathPlace, 128> paths;
std::array<std::atomic<pid_t>, 256> groups;
std::atomic<int> groups_beginning = 0;

/// Waits at most a second for process groups that are starting.
void await_groups() noexcept {
  for (int look = 0; look < 1000 && groups_beginning > 0; ++look) {
    const timespec pause{0, 1'000'000};
    ::nanosleep(&pause, nullptr);
  }
}

/// Removes a file or folder. A signal handler must not walk a folder, so another process does.
void remove(const PathPlace& place) noexcept {
  if (!place.folder) {
    ::unlink(place.path.data());
  } else if (::_Fork() == 0) {
    ::execl("/bin/rm", "rm", "-rf", "--", place.path.data(), nullptr);
    ::_exit(1);
  }
}

}  // namespace

Leftover::Leftover(const std::string& path, bool folder) {
  if (path.size() >= PATH_MAX) return;
  for (std::size_t i = 0; i < paths.size() && place_ < 0; ++i) {
    State expected = State::free;
    if (!paths[i].state.compare_exchange_strong(expected, State::taken)) continue;
    std::memcpy(paths[i].path.data(), path.c_str(), path.size() + 1);
    paths[i].folder = folder;
    paths[i].state = State::ready;
    place_ = static_cast<int>(i);
  }
}

Leftover::~Leftover() {
  if (place_ >= 0) paths[static_cast<std::size_t>(place_)].state = State::free;
}

void note_group(pid_t group) {
  for (std::atomic<pid_t>& place : groups) {
    pid_t none = 0;
    if (place.compare_exchange_strong(none, group)) return;
  }
}

void forget_group(pid_t group) {
  for (std::atomic<pid_t>& place : groups) {
    pid_t known = group;
    if (place.compare_exchange_strong(known, 0)) return;
  }
}

GroupBeginning::GroupBeginning() {
  sigset_t all;
  sigfillset(&all);
  ::pthread_sigmask(SIG_SETMASK, &all, &before_);
  ++groups_beginning;
}

GroupBeginning::~GroupBeginning() {
  --groups_beginning;
  ::pthread_sigmask(SIG_SETMASK, &before_, nullptr);
}

void remove_leftovers() noexcept {
  await_groups();
  for (std::atomic<pid_t>& place : groups)
    if (const pid_t group = place; group > 0) ::kill(-group, SIGKILL);
  for (PathPlace& place : paths)
    if (place.state == State::ready) remove(place);
}

}  // namespace stepwire::io
