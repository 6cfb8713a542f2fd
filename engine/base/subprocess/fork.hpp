#pragma once

#include <sys/types.h>

#include <functional>
#include <mutex>
#include <string>
#include <vector>

#include "engine/base/io/descriptor.hpp"

namespace stepwire::subprocess {

/// Mutex to hold during dlopen() and dlclose(): a fork in between would inherit the loader's own lock and
/// block for ever.
std::mutex& loader_mutex();

/// A forked copy of this process that runs one function. Signals have default handling in it, but terminal
/// interrupts are ignored: its owner ends it, also by exiting in whatever way. Processes that it starts are
/// killed after it. Of the open files and sockets it keeps the three standard streams and those in `kept`.
class Fork {
 public:
  Fork() = default;
  /// Forks; started() is false where the system refuses. The copy exits with status 0 after the function,
  /// which must not throw.
  Fork(const std::function<void()>& work, std::vector<int> kept);
  /// Kills it.
  ~Fork();
  Fork(const Fork&) = delete;
  Fork& operator=(const Fork&) = delete;

  bool started() const { return id_ > 0; }
  /// True once it has ended.
  bool has_ended();
  /// Waits for its end.
  void wait();
  /// Kills it and waits for its end.
  void end();
  /// Result after the end. status() is 0 after a signal; succeeded() is true for exit status 0. ending() is
  /// text: "was ended by signal 11 (Segmentation fault)" or "has ended itself with status 1".
  bool ended() const { return ended_; }
  int status() const;
  bool succeeded() const { return status_ == 0; }
  std::string ending() const;

 private:
  void look(int how);

  pid_t id_ = -1;
  io::Descriptor life_{};  ///< open for the lifetime of the parent
  int status_ = 0;
  bool ended_ = false;
};

}  // namespace stepwire::subprocess
