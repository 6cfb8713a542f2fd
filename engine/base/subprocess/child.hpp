#pragma once

#include <sys/types.h>

#include <string>
#include <vector>

#include "engine/base/io/descriptor.hpp"

namespace stepwire::subprocess {

/// A program that runs in a process group of its own, with the ends of its three streams. The group has a
/// guard, a shell that ends the group and removes the folder for temporary files where this process ends
/// first, in whatever way.
class Child {
 public:
  /// Begins it; alive() is false where that fails.
  Child(const std::vector<std::string>& command, const std::string& scratch);
  /// Ends the whole group.
  ~Child();
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;

  bool alive() const { return id_ > 0; }
  /// Has it ended by itself? It is still there to be waited for.
  bool ended() const;
  /// Ends the group, and gives the status that waitpid() has of the program.
  int end();

  io::Descriptor input, output, errors;

 private:
  /// Sends a signal that ends the group, and waits for its guard.
  void end_group();

  pid_t id_ = -1;
  pid_t guard_ = -1;       ///< leads the group
  io::Descriptor life_{};  ///< open as long as this process lives
};

}  // namespace stepwire::subprocess
