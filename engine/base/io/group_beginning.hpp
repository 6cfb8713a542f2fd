#pragma once

#include <csignal>

namespace stepwire::io {

/// Guard around the start of a process group. It blocks signals on its thread and makes remove_leftovers() on
/// other threads wait, so that the new group is registered before it could be missed.
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
