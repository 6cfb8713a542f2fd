#include "engine/base/subprocess/child.hpp"

#include <fcntl.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>

#include <array>
#include <cerrno>
#include <csignal>

#include "engine/base/io/group_beginning.hpp"
#include "engine/base/io/leftovers.hpp"

extern char** environ;

namespace stepwire::subprocess {

namespace {

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

/// Returns the environment of this process with TMPDIR set to another folder.
std::vector<std::string> environment_with(const std::string& scratch) {
  std::vector<std::string> result;
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
pid_t spawn(std::vector<std::string> command, const std::string& scratch, const std::array<int, 3>& streams,
            pid_t group) {
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  for (int stream = 0; stream < 3; ++stream)
    posix_spawn_file_actions_adddup2(&actions, streams[static_cast<std::size_t>(stream)], stream);
  const Attributes attributes(group);
  std::vector<std::string> variables = environment_with(scratch);
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
  return spawn({"/bin/sh", "-c", guard_script, "sh", scratch}, "", {life, nothing.number(), nothing.number()},
               0);
}

void await(pid_t id, int& status) {
  while (::waitpid(id, &status, 0) < 0 && errno == EINTR) {
  }
}

}  // namespace

Child::Child(const std::vector<std::string>& command, const std::string& scratch) {
  auto in = connection(), out = connection(), err = connection(), life = connection();
  if (!in[1].open() || !out[1].open() || !err[1].open() || !life[1].open()) return;
  {
    const io::GroupBeginning beginning;
    guard_ = spawn_guard(scratch, life[1].number());
    if (guard_ < 0) return;
    io::note_group(guard_);
    id_ = spawn(command, scratch, {in[1].number(), out[1].number(), err[1].number()}, guard_);
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

}  // namespace stepwire::subprocess
