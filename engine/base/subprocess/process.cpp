#include "engine/base/subprocess/process.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/types.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <string_view>

#include "engine/base/io/descriptor.hpp"
#include "engine/base/io/environment_error.hpp"
#include "engine/base/io/group_beginning.hpp"
#include "engine/base/io/leftovers.hpp"
#include "engine/base/subprocess/scratch_folder.hpp"

namespace stepwire::subprocess {
namespace {

/// A running program in a process group of its own, with the ends of its three streams. A guard, a shell in
/// the group, kills the group and removes its temporary folder if this process ends first, in whatever way.
class Child {
 public:
  /// Starts the program; alive() is false on failure.
  Child(const ProcessCall& call, const std::string& scratch);
  /// Kills the whole group.
  ~Child();
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;

  bool alive() const { return id_ > 0; }
  /// True once the program has exited. It remains a zombie until end().
  bool ended() const;
  /// Kills the group and returns the program's status of waitpid().
  int end();

  io::Descriptor input, output, errors;

 private:
  /// Kills the group and waits for its guard.
  void end_group();

  pid_t id_ = -1;
  pid_t guard_ = -1;       ///< leader of the group
  io::Descriptor life_{};  ///< open for the lifetime of this process
};

/// Makes a connected pair of sockets. A socket can be written without raising SIGPIPE, unlike a pipe.
std::array<io::Descriptor, 2> connection() {
  std::array<int, 2> ends{-1, -1};
  if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0) ends = {-1, -1};
  return {io::Descriptor(ends[0]), io::Descriptor(ends[1])};
}

/// Returns an argv array that points into `words`.
std::vector<char*> pointers(std::vector<std::string>& words) {
  std::vector<char*> result;
  for (std::string& word : words) result.push_back(word.data());
  result.push_back(nullptr);
  return result;
}

/// Returns the environment of this process with other variables, and TMPDIR set to another folder.
std::vector<std::string> environment_with(const std::vector<std::string>& variables,
                                          const std::string& scratch) {
  std::vector<std::string> result = variables;  // of two variables of one name programs take the first
  for (char** variable = environ; *variable; ++variable) {
    const std::string text = *variable;
    if (scratch.empty() || !text.starts_with("TMPDIR=")) result.push_back(text);
  }
  if (!scratch.empty()) result.push_back("TMPDIR=" + scratch);
  return result;
}

/// Spawn attributes: the process group (0 for a new one) and default signal handling. SIGXFSZ is ignored, so
/// that exceeding a file size limit is an error with a reason, as a full disk is.
class Attributes {
 public:
  explicit Attributes(pid_t group) {
    posix_spawnattr_init(&value);
    sigset_t none, all;
    sigemptyset(&none);
    sigfillset(&all);
    sigdelset(&all, SIGXFSZ);
    posix_spawnattr_setsigmask(&value, &none);
    posix_spawnattr_setsigdefault(&value, &all);
    posix_spawnattr_setpgroup(&value, group);
    posix_spawnattr_setflags(&value, POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF);
  }
  ~Attributes() { posix_spawnattr_destroy(&value); }
  Attributes(const Attributes&) = delete;
  Attributes& operator=(const Attributes&) = delete;

  posix_spawnattr_t value;
};

/// Starts a program in a group; -1 on failure.
pid_t spawn(const ProcessCall& call, const std::string& scratch, const std::array<int, 3>& streams,
            pid_t group) {
  std::vector<std::string> command = call.command;
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  for (int stream = 0; stream < 3; ++stream)
    posix_spawn_file_actions_adddup2(&actions, streams[static_cast<std::size_t>(stream)], stream);
  if (!call.folder.empty()) posix_spawn_file_actions_addchdir_np(&actions, call.folder.c_str());
  const Attributes attributes(group);
  std::vector<std::string> variables = environment_with(call.variables, scratch);
  pid_t id = -1;
  const int status = ::posix_spawnp(&id, command.front().c_str(), &actions, &attributes.value,
                                    pointers(command).data(), pointers(variables).data());
  posix_spawn_file_actions_destroy(&actions);
  return status == 0 ? id : -1;
}

/// The guard waits for the end of a connection and then ends its group. It sends SIGTERM first, since SIGKILL
/// ends the guard as well.
constexpr const char* guard_script =
    "read -r _ || { trap '' TERM; kill -TERM 0; rm -rf -- \"$1\"; kill -KILL 0; }";

pid_t spawn_guard(const std::string& scratch, int life) {
  const io::Descriptor nothing(::open("/dev/null", O_RDWR | O_CLOEXEC));
  const ProcessCall call{.command = {"/bin/sh", "-c", guard_script, "sh", scratch}};
  return spawn(call, "", {life, nothing.number(), nothing.number()}, 0);
}

void await(pid_t id, int& status) {
  while (::waitpid(id, &status, 0) < 0 && errno == EINTR) {
  }
}

Child::Child(const ProcessCall& call, const std::string& scratch) {
  auto in = connection(), out = connection(), err = connection(), life = connection();
  if (!in[1].open() || !out[1].open() || !err[1].open() || !life[1].open()) return;
  {
    const io::GroupBeginning beginning;
    guard_ = spawn_guard(scratch, life[1].number());
    if (guard_ < 0) return;
    io::note_group(guard_);
    id_ = spawn(call, scratch, {in[1].number(), out[1].number(), err[1].number()}, guard_);
  }
  if (!alive()) {
    end_group();
    return;
  }
  life_ = std::move(life[0]);
  input = std::move(in[0]);
  output = std::move(out[0]);
  errors = std::move(err[0]);
}

Child::~Child() {
  end();
}

bool Child::ended() const {
  siginfo_t info{};
  return ::waitid(P_PID, static_cast<id_t>(id_), &info, WEXITED | WNOHANG | WNOWAIT) == 0 && info.si_pid != 0;
}

void Child::end_group() {
  ::kill(-guard_, SIGKILL);
  io::forget_group(guard_);  // before the system reuses the number
  int status = 0;
  await(guard_, status);
}

int Child::end() {
  if (!alive()) return 0;
  ::kill(-guard_, SIGKILL);  // before waitpid(), while the guard still holds the group number
  int status = 0;
  await(id_, status);
  end_group();
  id_ = -1;
  return status;
}

using Clock = std::chrono::steady_clock;
using End = ProcessResult::End;

constexpr int milliseconds_between_looks = 20;
constexpr std::size_t max_errors = 1u << 16u;

/// Writes a part of a program's input; closes the stream at the end, or when the program has gone.
void send_some(io::Descriptor& to, std::string_view& rest) {
  const ssize_t count = ::send(to.number(), rest.data(), rest.size(), MSG_NOSIGNAL | MSG_DONTWAIT);
  if (count > 0) rest.remove_prefix(static_cast<std::size_t>(count));
  const bool gone = count < 0 && errno != EAGAIN && errno != EINTR;
  if (rest.empty() || gone) to.close();
}

/// Reads available bytes, of which `most` are kept; false if there were none.
bool receive(io::Descriptor& from, std::string& text, std::size_t most) {
  std::array<char, 1 << 16> buffer;
  const ssize_t count = ::recv(from.number(), buffer.data(), buffer.size(), MSG_DONTWAIT);
  if (count < 0 && (errno == EAGAIN || errno == EINTR)) return false;
  if (count <= 0) {
    from.close();
    return false;
  }
  text.append(buffer.data(), std::min(static_cast<std::size_t>(count), most - std::min(most, text.size())));
  return true;
}

/// Exchange of the streams with a program until it ends or has to be killed.
class Conversation {
 public:
  Conversation(Child& child, const ProcessCall& call, ProcessResult& result)
      : child_(child),
        call_(call),
        result_(result),
        rest_(call.input),
        end_(Clock::now() + (call.limit.count() > 0 ? call.limit : usual_limit())) {}

  End hold() {
    while (true) {
      if (call_.stop.stop_requested() || processes_stop()) return End::stopped;
      if (Clock::now() > end_) return End::overdue;
      if (result_.output.size() > call_.max_output) return End::too_much;
      if (child_.ended()) return finish();
      exchange();
    }
  }

 private:
  /// Writes and reads whichever stream is ready, so that neither side waits for ever.
  void exchange() {
    if (rest_.empty()) child_.input.close();
    std::array<pollfd, 3> waits{{{child_.input.number(), POLLOUT, 0},
                                 {child_.output.number(), POLLIN, 0},
                                 {child_.errors.number(), POLLIN, 0}}};
    // A program that has closed its streams is polled often: most such programs are about to end.
    const bool silent = !child_.output.open() && !child_.errors.open();
    if (::poll(waits.data(), waits.size(), silent ? 1 : milliseconds_between_looks) <= 0) return;
    if (child_.input.open() && waits[0].revents != 0) send_some(child_.input, rest_);
    if (child_.output.open() && waits[1].revents != 0)
      receive(child_.output, result_.output, call_.max_output + 1);
    if (child_.errors.open() && waits[2].revents != 0) receive(child_.errors, result_.errors, max_errors);
  }

  /// Reads the remaining output of a program that has ended. Its child processes may still hold the streams
  /// and are not waited for.
  End finish() {
    while (child_.output.open() && receive(child_.output, result_.output, call_.max_output + 1)) {
    }
    while (child_.errors.open() && receive(child_.errors, result_.errors, max_errors)) {
    }
    return result_.output.size() > call_.max_output ? End::too_much : End::exited;
  }

  Child& child_;
  const ProcessCall& call_;
  ProcessResult& result_;
  std::string_view rest_;
  Clock::time_point end_;
};

std::chrono::milliseconds limit_or(double seconds) {
  constexpr double most = 1e6;
  const char* given = std::getenv("STEPWIRE_HELPER_LIMIT");
  if (const double own = given ? std::strtod(given, nullptr) : 0.0; own > 0.0) seconds = std::min(own, most);
  return std::chrono::milliseconds(static_cast<std::int64_t>(1000.0 * seconds) + 1);
}

std::string trimmed(std::string text) {
  text.erase(text.find_last_not_of(" \n") + 1);
  text.erase(0, std::min(text.find_first_not_of(" \n"), text.size()));
  return text;
}

std::string end_text(End end, int status) {
  switch (end) {
    case End::overdue:
      return "does not come to an end and was ended; STEPWIRE_HELPER_LIMIT allows more seconds";
    case End::too_much:
      return "writes without end and was ended";
    case End::not_started:
      return "could not be run";
    case End::stopped:
      return "was stopped";
    case End::killed:
      return "was killed by a signal";
    default:
      return fmt::format("ended with exit code {}", status);
  }
}

}  // namespace

std::string ProcessResult::problem(const std::string& name) const {
  if (succeeded()) return "";
  const bool spoke = end == End::exited && !errors.empty();
  return spoke ? errors : fmt::format("{} {}", name, end_text(end, status));
}

std::string find_program(const std::string& name) {
  const char* path = std::getenv("PATH");
  std::string_view rest = path == nullptr ? "/usr/local/bin:/usr/bin:/bin" : path;
  while (!rest.empty()) {
    const auto colon = rest.find(':');
    const std::string file = std::string(rest.substr(0, colon)) + "/" + name;
    if (::access(file.c_str(), X_OK) == 0) return file;
    rest.remove_prefix(colon == std::string_view::npos ? rest.size() : colon + 1);
  }
  return {};
}

std::chrono::milliseconds usual_limit() {
  return limit_or(60.0);
}

std::chrono::milliseconds compiler_limit() {
  return limit_or(300.0);
}

std::atomic<bool>& processes_stop() {
  static std::atomic<bool> stop = false;
  return stop;
}

ProcessResult run_process(const ProcessCall& call) {
  ProcessResult result;
  if (processes_stop()) {
    result.end = End::stopped;
    return result;
  }
  const ScratchFolder scratch;
  Child child(call, scratch.path());
  if (!child.alive()) return result;
  result.end = Conversation(child, call, result).hold();
  const int status = child.end();
  if (result.end == End::exited && !WIFEXITED(status)) result.end = End::killed;
  if (result.end == End::exited) result.status = WEXITSTATUS(status);
  result.errors = trimmed(result.errors);
  return result;
}

ProcessResult run_helper(const std::string& name, const ProcessCall& call) {
  ProcessResult result = run_process(call);
  if (result.end == End::stopped) throw ProcessStopped(name + " was stopped");
  if (!result.succeeded()) throw io::EnvironmentError(result.problem(name));
  return result;
}

}  // namespace stepwire::subprocess
