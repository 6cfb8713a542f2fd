#include "engine/base/messages/worker_process.hpp"

#include <poll.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <utility>

#include "engine/base/io/descriptor.hpp"
#include "engine/base/io/environment_error.hpp"

namespace stepwire::messages {

namespace {

[[noreturn]] void refuse(const std::string& what) {
  throw io::EnvironmentError("the process that works cannot be begun: " + what);
}

[[noreturn]] void note_gone() {
  throw io::EnvironmentError("the other process of this one has gone");
}

/// A local socket; each message is preceded by its length.
class LocalConnection : public Connection {
 public:
  explicit LocalConnection(io::Descriptor socket) : socket_(std::move(socket)) {}

  void send(std::string_view bytes) override {
    const std::uint64_t size = bytes.size();
    write({reinterpret_cast<const char*>(&size), sizeof(size)});
    write(bytes);
  }

  std::optional<std::string> receive(std::chrono::milliseconds wait) override {
    const auto end = std::chrono::steady_clock::now() + wait;
    while (true) {
      if (auto message = take()) return message;
      const auto left =
          std::chrono::ceil<std::chrono::milliseconds>(end - std::chrono::steady_clock::now()).count();
      pollfd one{socket_.number(), POLLIN, 0};
      if (::poll(&one, 1, left > 0 ? static_cast<int>(left) : 0) <= 0) {
        if (left <= 0) return std::nullopt;
      } else {
        read();
      }
    }
  }

 private:
  void write(std::string_view bytes) {
    while (!bytes.empty()) {
      const ssize_t written = ::send(socket_.number(), bytes.data(), bytes.size(), MSG_NOSIGNAL);
      if (written < 0 && errno == EINTR) continue;
      if (written <= 0) note_gone();
      bytes.remove_prefix(static_cast<std::size_t>(written));
    }
  }

  void read() {
    std::array<char, 65536> piece;
    const ssize_t count = ::recv(socket_.number(), piece.data(), piece.size(), 0);
    if (count < 0 && errno == EINTR) return;
    if (count <= 0) note_gone();
    came_.append(piece.data(), static_cast<std::size_t>(count));
  }

  /// Returns a completely received message; std::nullopt if there is none.
  std::optional<std::string> take() {
    std::uint64_t size = 0;
    if (came_.size() - taken_ < sizeof(size)) return std::nullopt;
    std::memcpy(&size, came_.data() + taken_, sizeof(size));
    if (came_.size() - taken_ - sizeof(size) < size) return std::nullopt;
    std::string message = came_.substr(taken_ + sizeof(size), size);
    taken_ += sizeof(size) + size;
    if (taken_ >= came_.size() / 2) came_.erase(0, std::exchange(taken_, 0));
    return message;
  }

  io::Descriptor socket_;
  std::string came_;
  std::size_t taken_ = 0;  ///< number of consumed bytes
};

}  // namespace

WorkerProcess::WorkerProcess() {
  std::array<int, 2> ends{};
  if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0) refuse(std::strerror(errno));
  io::Descriptor here(ends[0]), there(ends[1]);
  std::fflush(nullptr);  // otherwise both processes would write the buffered output
  const pid_t parent = ::getpid();
  process_ = ::fork();
  if (process_ < 0) refuse(std::strerror(errno));
  connection_ = std::make_unique<LocalConnection>(std::move(is_worker() ? there : here));
  if (!is_worker()) return;
  ::prctl(PR_SET_PDEATHSIG, SIGTERM);
  if (::getppid() != parent) ::_exit(1);  // the parent died before prctl()
}

WorkerProcess::~WorkerProcess() {
  if (!is_worker()) end();
}

std::optional<std::string> WorkerProcess::death() {
  int status = 0;
  if (process_ <= 0 || ::waitpid(process_, &status, WNOHANG) != process_) return std::nullopt;
  process_ = -1;
  if (WIFSIGNALED(status)) return "signal " + std::to_string(WTERMSIG(status));
  if (WEXITSTATUS(status) != 0) return "status " + std::to_string(WEXITSTATUS(status));
  return std::nullopt;
}

void WorkerProcess::end() {
  if (process_ <= 0) return;
  ::kill(process_, SIGTERM);
  while (::waitpid(process_, nullptr, 0) < 0 && errno == EINTR) continue;
  process_ = -1;
}

}  // namespace stepwire::messages
