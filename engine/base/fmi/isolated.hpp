#pragma once

#include <sys/types.h>

#include "engine/base/fmi/runner.hpp"

namespace stepwire::fmi {

/// A unit in a process of its own. Both processes have the exchange in shared memory, and take turns.
class Isolated : public Runner {
 public:
  Isolated(const Setup& setup, const Counts& counts);
  ~Isolated() override;
  Isolated(const Isolated&) = delete;
  Isolated& operator=(const Isolated&) = delete;

  bool run(Operation operation) override;

 private:
  void live(pid_t parent);
  bool has_ended();

  Setup setup_;
  std::size_t bytes_;
  pid_t child_ = -1;
  int status_ = 0;
  bool ended_ = false;
};

}  // namespace stepwire::fmi
