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

/// Two ends of a connection. A socket rather than a pipe, since a write to it need not raise SIGPIPE.
std::array<io::Descriptor, 2> connection() {
  std::array<int, 2> ends{-1, -1};
  if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0) ends = {-1, -1};
  return {io::Descriptor(ends[0]), io::Descriptor(ends[1])};
}

/// Words as the system takes them; they live as long as the strings.
std::vector<char*> pointers(std::vector<std::string>& words) {
  std::vector<char*> result;
  for (std::string& word : words) result.push_back(word.data());
  result.push_back(nullptr);
  return result;
}

/// The environment of this process, with another folder for temporary files.
std::vector<std::string> environment_with(const std::string& scratch) {
  std::vector<std::string> result;
  for (char** variable = environ; *variable; ++variable) {
    const std::string text = *variable;
    if (scratch.empty() || !text.starts_with("TMPDIR=")) result.push_back(text);
  }
  if (!scratch.empty()) result.push_back("TMPDIR=" + scratch);
  return result;
}

/// A group of its own, and signals as a new program finds them, whatever this one does with them. A file that
/// may not grow stays an error with a reason, as a full disk is.
class Attributes {
 public:
  Attributes() {
    posix_spawnattr_init(&value);
    sigset_t none, all;
    sigemptyset(&none);
    sigfillset(&all);
    sigdelset(&all, SIGXFSZ);
    posix_spawnattr_setsigmask(&value, &none);
    posix_spawnattr_setsigdefault(&value, &all);
    posix_spawnattr_setpgroup(&value, 0);
    posix_spawnattr_setflags(&value, POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF);
  }
  ~Attributes() { posix_spawnattr_destroy(&value); }
  Attributes(const Attributes&) = delete;
  Attributes& operator=(const Attributes&) = delete;

  posix_spawnattr_t value;
};

pid_t spawn(std::vector<std::string> command, const std::string& scratch, const std::array<int, 3>& streams) {
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  for (int stream = 0; stream < 3; ++stream)
    posix_spawn_file_actions_adddup2(&actions, streams[static_cast<std::size_t>(stream)], stream);
  const Attributes attributes;
  std::vector<std::string> variables = environment_with(scratch);
  pid_t id = -1;
  const int status = ::posix_spawnp(&id, command.front().c_str(), &actions, &attributes.value,
                                    pointers(command).data(), pointers(variables).data());
  posix_spawn_file_actions_destroy(&actions);
  return status == 0 ? id : -1;
}

}  // namespace

Child::Child(const std::vector<std::string>& command, const std::string& scratch) {
  auto in = connection(), out = connection(), err = connection();
  if (!in[1].open() || !out[1].open() || !err[1].open()) return;
  {
    const io::GroupBeginning beginning;
    id_ = spawn(command, scratch, {in[1].number(), out[1].number(), err[1].number()});
    if (!alive()) return;
    io::note_group(id_);
  }
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

int Child::end() {
  if (!alive()) return 0;
  ::kill(-id_, SIGKILL);
  io::forget_group(id_);  // before another process may get its number
  int status = 0;
  while (::waitpid(id_, &status, 0) < 0 && errno == EINTR) {
  }
  id_ = -1;
  return status;
}

}  // namespace stepwire::subprocess
