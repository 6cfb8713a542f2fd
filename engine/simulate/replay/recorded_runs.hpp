#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "engine/simulate/replay/recorded.hpp"

namespace stepwire::replay {

/// Iterator over the runs of a sweep in the file of a recording.
class RecordedRuns {
 public:
  virtual ~RecordedRuns() = default;

  /// Returns the rows of the next run, valid until the next call. Throws Error if they do not have the
  /// columns of the plan's recording; TableError, EnvironmentError.
  virtual RecordedRows next() = 0;
  /// Marks the first `rows` rows of them as rows of the run.
  virtual void take(std::size_t rows) = 0;
  /// Returns a text on the first row that is in no run, with its place; an empty text without one.
  virtual std::string left_over() = 0;
};

/// Recorded sweep: its plan, its parameters and the number of its runs.
struct RecordedSweep {
  const plan::Plan& plan;
  const std::vector<std::string>& swept;  ///< columns, or values of each run
  std::size_t runs;
  const std::vector<std::size_t>* numbers = nullptr;  ///< indices of the runs, from 0; nullptr: all
};

/// Opens the file of a recording, recorded_file(), for a request of the plan. Text files are read as a whole,
/// HDF5 files some runs at a time. The objects in `sweep` must outlive it. Throws as next() does.
std::unique_ptr<RecordedRuns> open_recorded_runs(const std::string& file, std::size_t request,
                                                 const RecordedSweep& sweep);

}  // namespace stepwire::replay
