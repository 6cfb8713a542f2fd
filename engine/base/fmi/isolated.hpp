#pragma once

#include <optional>

#include "engine/base/fmi/runner.hpp"
#include "engine/base/subprocess/fork.hpp"

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
  void quit();

  Setup setup_;
  std::size_t bytes_;
  std::optional<subprocess::Fork> process_;
};

}  // namespace stepwire::fmi
