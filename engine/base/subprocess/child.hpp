#pragma once

#include <sys/types.h>

#include <string>
#include <vector>

#include "engine/base/io/descriptor.hpp"

namespace stepwire::subprocess {

/// A running program in a process group of its own, with the ends of its three streams. A guard, a shell in
/// the group, kills the group and removes its temporary folder if this process ends first, in whatever way.
class Child {
 public:
  /// Starts the program; alive() is false on failure.
  Child(const std::vector<std::string>& command, const std::string& scratch);
  /// Kills the whole group.
  ~Child();
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;

  bool alive() const { return id_ > 0; }
  /// True once the program has exited. It remains a zombie until end().
  bool ended() const;
  /// Kills the group and returns the program's status of waitpid().
  int end();

  io::Descriptor input, output, errors;

 private:
  /// Kills the group and waits for its guard.
  void end_group();

  pid_t id_ = -1;
  pid_t guard_ = -1;       ///< leader of the group
  io::Descriptor life_{};  ///< open for the lifetime of this process
};

}  // namespace stepwire::subprocess
