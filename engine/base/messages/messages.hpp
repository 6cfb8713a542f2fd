#pragma once

#include <chrono>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

namespace stepwire::messages {

/// A message of one process to another.
struct Message {
  int from = 0;
  std::string bytes;
};

/// A way to one other process. One thread at a time.
class Connection {
 public:
  virtual ~Connection() = default;
  /// Sends bytes, in their order. Throws EnvironmentError where the other process has gone.
  virtual void send(std::string_view bytes) = 0;
  /// The next bytes that came, which may take so long; nothing where none came. Throws EnvironmentError where
  /// the other process has gone, and all that it has sent is read.
  virtual std::optional<std::string> receive(std::chrono::milliseconds wait) = 0;
};

/// Processes that one call has started on one machine or on several, numbered from 0. One thread at a time.
class Messages {
 public:
  virtual ~Messages() = default;
  virtual int rank() const = 0;  ///< of this process
  virtual int size() const = 0;  ///< of all
  /// Sends bytes, in their order, and does not wait until they are read. Throws EnvironmentError.
  virtual void send(int to, std::string_view bytes) = 0;
  /// The next message of any process, which may take so long; nothing where none came. Throws
  /// EnvironmentError.
  virtual std::optional<Message> receive(std::chrono::milliseconds wait) = 0;
  /// Waits until all processes come to this call.
  virtual void finish() = 0;
  /// Ends all processes at once, where some of them may have died; the call that started them ends with this
  /// status.
  [[noreturn]] virtual void abort(int status) = 0;
};

/// The processes of mpirun, by the module for MPI. Throws EnvironmentError where the program was built
/// without it.
std::unique_ptr<Messages> open_mpi();

}  // namespace stepwire::messages
