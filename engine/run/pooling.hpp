#pragma once

#include <string>
#include <vector>

#include "engine/run/run.hpp"

namespace stepwire {

/// Which value each axis takes at a point: the last axis runs fastest.
std::vector<std::size_t> indices_of(const Sweep& sweep, std::size_t point);

/// "speed=3, mass=1 kg".
std::string settings_text(const std::vector<Setting>& settings);

/// What tells apart the recordings of a job's points: its swept parameters, as columns behind the time. None
/// without a sweep.
class SweptColumns {
 public:
  /// The job must outlive it.
  explicit SweptColumns(const Job& job);

  /// Of one row.
  std::vector<Column> of(std::size_t point) const;
  /// Adds them to what was recorded at a point.
  void add(Recording& recording, std::size_t point) const;

 private:
  const Job& job_;
  std::vector<bool>
      numeric_;  ///< axes of numbers only; where one value is a word, all values of the axis are
};

/// Puts the runs of a recording behind those of another one, which has the same columns or none yet.
void append_runs(Recording& all, Recording&& more);

}  // namespace stepwire
