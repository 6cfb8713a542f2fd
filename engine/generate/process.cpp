#include "engine/generate/process.hpp"

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>

extern char** environ;

namespace stepwire {

namespace {

constexpr int milliseconds_between_looks = 20;  // at the stop

/// A started program whose output comes through a pipe.
struct Child {
  pid_t id = -1;
  int output = -1;
};

Child start(const std::vector<std::string>& command) {
  int ends[2];
  if (::pipe2(ends, O_CLOEXEC) != 0) return {};
  std::vector<char*> arguments;
  for (const std::string& argument : command) arguments.push_back(const_cast<char*>(argument.c_str()));
  arguments.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, ends[1], STDOUT_FILENO);
  posix_spawn_file_actions_adddup2(&actions, ends[1], STDERR_FILENO);
  Child child{-1, ends[0]};
  const int problem = ::posix_spawnp(&child.id, arguments[0], &actions, nullptr, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  ::close(ends[1]);
  if (problem == 0) return child;
  ::close(ends[0]);
  return {};
}

/// Reads until the program has closed its output, which is when it ends; false if it was stopped.
bool read_all(const Child& child, const std::stop_token& stop, std::string& output) {
  char buffer[4096];
  while (!stop.stop_requested()) {
    pollfd ready{child.output, POLLIN, 0};
    if (::poll(&ready, 1, milliseconds_between_looks) == 0) continue;
    const ssize_t count = ::read(child.output, buffer, sizeof buffer);
    if (count <= 0) return true;
    output.append(buffer, static_cast<std::size_t>(count));
  }
  return false;
}

}  // namespace

ProcessResult run_process(const std::vector<std::string>& command, const std::stop_token& stop) {
  const Child child = start(command);
  ProcessResult result;
  if (child.id < 0) return result;
  const bool ended = read_all(child, stop, result.output);
  if (!ended) ::kill(child.id, SIGKILL);
  ::close(child.output);
  int status = 0;
  ::waitpid(child.id, &status, 0);
  if (ended && WIFEXITED(status)) result.status = WEXITSTATUS(status);
  return result;
}

}  // namespace stepwire
