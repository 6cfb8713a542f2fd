#pragma once

#include <chrono>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

namespace stepwire::messages {

/// A message received from another process.
struct Message {
  int from = 0;
  std::string bytes;
};

/// Connection to one other process. Not thread-safe.
class Connection {
 public:
  virtual ~Connection() = default;
  /// Sends bytes; the order is preserved. Throws EnvironmentError where the other process has ended.
  virtual void send(std::string_view bytes) = 0;
  /// Returns the next message within the given time; std::nullopt after it. Throws EnvironmentError where the
  /// other process has ended and all its messages have been read.
  virtual std::optional<std::string> receive(std::chrono::milliseconds wait) = 0;
};

/// Group of processes started by one call on one or several machines, numbered from 0. Not thread-safe.
class Messages {
 public:
  virtual ~Messages() = default;
  virtual int rank() const = 0;  ///< number of this process
  virtual int size() const = 0;  ///< number of processes
  /// Sends bytes without waiting for the receiver; the order is preserved. Throws EnvironmentError.
  virtual void send(int to, std::string_view bytes) = 0;
  /// Returns the next message of any process within the given time; std::nullopt after it. Throws
  /// EnvironmentError.
  virtual std::optional<Message> receive(std::chrono::milliseconds wait) = 0;
  /// Waits until all processes have called finish().
  virtual void finish() = 0;
  /// Kills all processes at once where some of them may have died; the call ends with this status.
  [[noreturn]] virtual void abort(int status) = 0;
};

/// Joins the processes of mpirun by the module for MPI. Throws EnvironmentError if that was not built.
std::unique_ptr<Messages> open_mpi();

}  // namespace stepwire::messages
