#pragma once

#include <cstdint>
#include <vector>

#include "engine/simulate/run/executor.hpp"

namespace stepwire::live {

/// Moments of a run to return to: one for each interval of time, and of those that lie further back fewer and
/// fewer, so that they never take more than the memory that they may.
class Moments {
 public:
  /// `every` [ticks] between two moments.
  explicit Moments(std::int64_t every, std::size_t bytes = std::size_t{256} << 20)
      : every_(every), bytes_(bytes) {}

  /// Is a moment of this tick due?
  bool due(std::int64_t tick) const { return tick >= next_; }
  /// Keeps the moment between two ticks, of a run that is there for the first time.
  void keep(const run::Workspace& workspace);
  /// The last one at or before a tick; null where there is none.
  const run::Workspace* before(std::int64_t tick) const;
  /// Forgets what lies behind a tick.
  void cut(std::int64_t tick);
  std::size_t size() const { return kept_.size(); }

 private:
  void thin();

  std::int64_t every_, next_ = 0;
  std::size_t bytes_;
  std::vector<run::Workspace> kept_;
};

}  // namespace stepwire::live
