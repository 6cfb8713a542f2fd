#pragma once

#include <optional>

#include "engine/base/fmi/runner.hpp"
#include "engine/base/subprocess/fork.hpp"

namespace stepwire::fmi {

/// A unit in a process of its own. Both processes have the exchange in shared memory and take turns. An
/// operation ends that process if it exceeds the time limit of helper programs, or lasts a second after an
/// interruption.
class Isolated : public Runner {
 public:
  Isolated(const Setup& setup, const Counts& counts);
  ~Isolated() override;
  Isolated(const Isolated&) = delete;
  Isolated& operator=(const Isolated&) = delete;

  bool run(Operation operation) override;

 private:
  void live();
  void quit();
  /// Kills the process; the operation fails with this reason.
  bool end(const char* why);
  bool fail(const std::string& why);

  Setup setup_;
  std::size_t bytes_;
  long limit_;  ///< of one operation, in waits
  std::optional<subprocess::Fork> process_;
};

}  // namespace stepwire::fmi
