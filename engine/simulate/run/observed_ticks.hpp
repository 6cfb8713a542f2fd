#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/simulate/run/observer.hpp"

namespace stepwire::run {

/// Shows observers the ticks of one run.
class ObservedTicks {
 public:
  /// `rows`: do the observers read what is recorded? Simulation and observers must outlive it.
  ObservedTicks(const ObservedRun& run, std::span<RunObserver* const> observers, bool rows = true);

  void begin() const;
  /// How the run goes on: as the strictest of the observers says.
  Flow before_tick() const;
  /// After the outputs of the tick are computed; shows the rows that are due, at the last tick all.
  void evaluated(bool last = false);
  /// Shows a row of one side of an instant, where both are recorded.
  void side(const double* values);
  void end() const;

 private:
  struct Row {
    std::int64_t every = 1;  ///< period [ticks]
    bool instants = false;
    std::vector<std::size_t> offsets;  ///< in the workspace, the time first
    std::vector<double> numbers;
  };

  void show(std::size_t recording, const double* values);

  ObservedRun run_;
  std::span<RunObserver* const> observers_;
  std::vector<Row> rows_;
};

}  // namespace stepwire::run
