#pragma once

#include <sys/types.h>

#include <memory>
#include <optional>
#include <string>

#include "engine/base/messages/messages.hpp"

namespace stepwire::messages {

/// A forked worker process. It may crash without this process, and ends with it.
class WorkerProcess {
 public:
  /// Forks this process, which must have a single thread; both continue from here. Throws EnvironmentError.
  WorkerProcess();
  /// Kills the worker; has no effect in the worker itself.
  ~WorkerProcess();
  WorkerProcess(const WorkerProcess&) = delete;
  WorkerProcess& operator=(const WorkerProcess&) = delete;

  /// True in the worker.
  bool is_worker() const { return process_ == 0; }
  /// Connection to the other process of the two.
  Connection& other() { return *connection_; }
  pid_t process() const { return process_; }
  /// Returns how the worker died, as "signal 9"; std::nullopt while it lives and after a normal exit.
  std::optional<std::string> death();
  /// Kills the worker.
  void end();

 private:
  pid_t process_ = -1;  ///< of the worker; 0 in it, -1 after its end
  std::unique_ptr<Connection> connection_;
};

}  // namespace stepwire::messages
