#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "engine/simulate/replay/recorded.hpp"

namespace stepwire::replay {

/// The runs of a sweep in the file of a recording, one after the other.
class RecordedRuns {
 public:
  virtual ~RecordedRuns() = default;

  /// The rows of the next run, which are there until the next call. Throws Error where they do not have the
  /// columns of the plan's recording; TableError, EnvironmentError.
  virtual RecordedRows next() = 0;
  /// So many of them were the run's.
  virtual void take(std::size_t rows) = 0;
  /// What is there that no run has taken, as a text with its place; empty where nothing is.
  virtual std::string left_over() = 0;
};

/// What is recorded of a sweep, and of how many runs.
struct RecordedSweep {
  const plan::Plan& plan;
  const std::vector<std::string>& swept;  ///< columns, or values of each run
  std::size_t runs;
  const std::vector<std::size_t>* numbers = nullptr;  ///< which runs these are, from 0; null: all
};

/// Opens the file of a recording, recorded_file(), for the request of the plan with this number: text is read
/// whole, HDF5 some runs at a time. The objects behind `sweep` must outlive it. Throws as next() does.
std::unique_ptr<RecordedRuns> open_recorded_runs(const std::string& file, std::size_t request,
                                                 const RecordedSweep& sweep);

}  // namespace stepwire::replay
