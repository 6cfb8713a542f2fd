#pragma once

#include <cstdint>
#include <vector>

#include "engine/simulate/run/executor.hpp"

namespace stepwire::live {

/// Checkpoints of a run, for returning to an earlier tick. They are taken at a regular interval and thinned
/// out with age, so that they stay within a memory limit.
class Moments {
 public:
  /// `every`: ticks between two checkpoints.
  explicit Moments(std::int64_t every, std::size_t bytes = std::size_t{256} << 20)
      : every_(every), bytes_(bytes) {}

  /// True if a checkpoint is due at this tick.
  bool due(std::int64_t tick) const { return tick >= next_; }
  /// Stores a checkpoint between two ticks; its tick must be after all stored ones.
  void keep(const run::Workspace& workspace);
  /// Returns the last checkpoint at or before a tick, or nullptr.
  const run::Workspace* before(std::int64_t tick) const;
  /// Removes the checkpoints after a tick.
  void cut(std::int64_t tick);
  std::size_t size() const { return kept_.size(); }

 private:
  void thin();

  std::int64_t every_, next_ = 0;
  std::size_t bytes_;
  std::vector<run::Workspace> kept_;
};

}  // namespace stepwire::live
