#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/simulate/run/observer.hpp"

namespace stepwire::run {

/// Passes the ticks of one run to its observers.
class ObservedTicks {
 public:
  /// `rows` is true if the observers read the recorded rows. Simulation and observers must outlive this
  /// object.
  ObservedTicks(const ObservedRun& run, std::span<RunObserver* const> observers, bool rows = true);

  void begin() const;
  /// Returns the strictest of the observers' decisions.
  Flow before_tick() const;
  /// Calls the observers after the outputs of the tick are computed, with the rows that are due; at the last
  /// tick with all rows.
  void evaluated(bool last = false);
  /// Passes the row of one side of an instant, where both sides are recorded.
  void side(const double* values);
  void end() const;

 private:
  struct Row {
    std::int64_t every = 1;  ///< period [ticks]
    bool instants = false;
    std::vector<std::size_t> offsets;  ///< places in the workspace, the time first
    std::vector<double> numbers;
  };

  void show(std::size_t recording, const double* values);

  ObservedRun run_;
  std::span<RunObserver* const> observers_;
  std::vector<Row> rows_;
};

}  // namespace stepwire::run
