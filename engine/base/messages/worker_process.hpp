#pragma once

#include <sys/types.h>

#include <memory>
#include <optional>
#include <string>

#include "engine/base/messages/messages.hpp"

namespace stepwire::messages {

/// A process beside this one that works for it, and may die without it. It ends with this one.
class WorkerProcess {
 public:
  /// Makes the process out of this one, which must have a single thread: from here on both go on. Throws
  /// EnvironmentError.
  WorkerProcess();
  /// Ends the worker, where this is not it.
  ~WorkerProcess();
  WorkerProcess(const WorkerProcess&) = delete;
  WorkerProcess& operator=(const WorkerProcess&) = delete;

  /// Is this the one that works?
  bool is_worker() const { return process_ == 0; }
  /// To the other one of the two.
  Connection& other() { return *connection_; }
  pid_t process() const { return process_; }
  /// How the worker died: "signal 9"; nothing while it lives, and where it ended by itself.
  std::optional<std::string> death();
  /// Ends the worker at once.
  void end();

 private:
  pid_t process_ = -1;  ///< of the worker; 0 in it, -1 once it has ended
  std::unique_ptr<Connection> connection_;
};

}  // namespace stepwire::messages
