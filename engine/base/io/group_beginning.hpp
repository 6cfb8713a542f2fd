#pragma once

#include <csignal>

namespace stepwire::io {

/// While one exists, its thread takes no signals, and remove_leftovers() on another thread waits for its end: a
/// process group that begins meanwhile is noted before it could be missed.
class GroupBeginning {
 public:
  GroupBeginning();
  ~GroupBeginning();
  GroupBeginning(const GroupBeginning&) = delete;
  GroupBeginning& operator=(const GroupBeginning&) = delete;

 private:
  sigset_t before_{};
};

}  // namespace stepwire::io
