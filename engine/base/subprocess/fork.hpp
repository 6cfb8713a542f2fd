#pragma once

#include <sys/types.h>

#include <functional>
#include <mutex>
#include <string>
#include <vector>

#include "engine/base/io/descriptor.hpp"

namespace stepwire::subprocess {

/// Held while a library is loaded or unloaded: a copy of the process that was made meanwhile would find the
/// loader's own lock taken for ever.
std::mutex& loader_mutex();

/// A copy of this process in which one function runs. Signals have their usual meaning in it, but the
/// terminal does not interrupt it: whoever made it ends it, also by ending itself in whatever way. Processes
/// that it makes end when it has ended. Of the
/// files and sockets of this process it sees the three streams and those that are kept.
class Fork {
 public:
  Fork() = default;
  /// Begins it; started() is false where the system gives no process. A copy ends with status 0 behind the
  /// function, which does not throw.
  Fork(const std::function<void()>& work, std::vector<int> kept);
  /// Ends it.
  ~Fork();
  Fork(const Fork&) = delete;
  Fork& operator=(const Fork&) = delete;

  bool started() const { return id_ > 0; }
  /// Has it ended by itself?
  bool has_ended();
  /// Waits for it.
  void wait();
  /// Ends it, and waits for it.
  void end();
  /// What is known of it once it has ended: its status, 0 where a signal has ended it; whether it did what it
  /// was made for; and "was ended by signal 11 (Segmentation fault)" or "has ended itself with status 1".
  bool ended() const { return ended_; }
  int status() const;
  bool succeeded() const { return status_ == 0; }
  std::string ending() const;

 private:
  void look(int how);

  pid_t id_ = -1;
  io::Descriptor life_{};  ///< open as long as the process of this object lives
  int status_ = 0;
  bool ended_ = false;
};

}  // namespace stepwire::subprocess
