#include "engine/process/filter.hpp"

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <string_view>
#include <utility>
#include <vector>

#include "engine/table/surroundings.hpp"

extern char** environ;

namespace stepwire {
namespace {

/// A file descriptor that is closed when it goes.
class Descriptor {
 public:
  Descriptor() = default;
  explicit Descriptor(int number) : number_(number) {}
  Descriptor(Descriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
  Descriptor& operator=(Descriptor&& other) noexcept {
    std::swap(number_, other.number_);
    return *this;
  }
  ~Descriptor() { close(); }
  int number() const { return number_; }
  bool open() const { return number_ >= 0; }
  void close() {
    if (number_ >= 0) ::close(number_);
    number_ = -1;
  }

 private:
  int number_ = -1;
};

[[noreturn]] void fail(const std::string& what) {
  throw SurroundingsError("a program cannot be run: " + what + ": " + std::strerror(errno));
}

/// Two ends of a connection. A socket rather than a pipe, since writing to a socket can be told not to raise
/// SIGPIPE.
std::array<Descriptor, 2> connection() {
  std::array<int, 2> ends{};
  if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0) fail("no connection");
  return {Descriptor(ends[0]), Descriptor(ends[1])};
}

/// The words of a command as the system wants them; they live as long as the strings.
std::vector<char*> pointers(std::vector<std::string>& words) {
  std::vector<char*> result;
  for (std::string& word : words) result.push_back(word.data());
  result.push_back(nullptr);
  return result;
}

pid_t start(std::vector<std::string> command, int input, int output, int errors) {
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, input, 0);
  posix_spawn_file_actions_adddup2(&actions, output, 1);
  posix_spawn_file_actions_adddup2(&actions, errors, 2);
  pid_t child = 0;
  const int status =
      ::posix_spawn(&child, command.front().c_str(), &actions, nullptr, pointers(command).data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  errno = status;
  if (status != 0) fail(command.front());
  return child;
}

void receive(Descriptor& from, std::string& text) {
  std::array<char, 16384> buffer;
  const ssize_t count = ::read(from.number(), buffer.data(), buffer.size());
  if (count > 0)
    text.append(buffer.data(), static_cast<std::size_t>(count));
  else if (count == 0 || (errno != EAGAIN && errno != EINTR))
    from.close();
}

void send_some(Descriptor& to, std::string_view& rest) {
  const ssize_t count = ::send(to.number(), rest.data(), rest.size(), MSG_NOSIGNAL | MSG_DONTWAIT);
  if (count > 0) rest.remove_prefix(static_cast<std::size_t>(count));
  const bool gone = count < 0 && errno != EAGAIN && errno != EINTR;
  if (rest.empty() || gone) to.close();
}

/// Writes and reads as either side is ready, so that neither waits for the other for ever.
FilterAnswer converse(Descriptor input, Descriptor output, Descriptor errors, std::string_view text) {
  FilterAnswer answer;
  while (output.open() || errors.open()) {
    std::array<pollfd, 3> waits{
        {{input.number(), POLLOUT, 0}, {output.number(), POLLIN, 0}, {errors.number(), POLLIN, 0}}};
    if (::poll(waits.data(), waits.size(), -1) < 0 && errno != EINTR) fail("no answer");
    if (input.open() && waits[0].revents != 0) send_some(input, text);
    if (output.open() && waits[1].revents != 0) receive(output, answer.output);
    if (errors.open() && waits[2].revents != 0) receive(errors, answer.complaints);
  }
  return answer;
}

int wait_for(pid_t child) {
  int status = 0;
  while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  return status;
}

std::string trimmed(std::string text) {
  text.erase(text.find_last_not_of(" \n") + 1);
  text.erase(0, std::min(text.find_first_not_of(" \n"), text.size()));
  return text;
}

}  // namespace

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

FilterAnswer run_filter(const std::string& program, const std::vector<std::string>& arguments,
                        const std::string& text) {
  std::vector<std::string> command{program};
  command.insert(command.end(), arguments.begin(), arguments.end());
  auto input = connection(), output = connection(), errors = connection();
  const pid_t child = start(std::move(command), input[1].number(), output[1].number(), errors[1].number());
  for (auto* ends : {&input, &output, &errors}) (*ends)[1].close();
  FilterAnswer answer = converse(std::move(input[0]), std::move(output[0]), std::move(errors[0]), text);
  const int status = wait_for(child);
  answer.complaints = trimmed(answer.complaints);
  if (WIFEXITED(status)) answer.status = WEXITSTATUS(status);
  return answer;
}

}  // namespace stepwire
