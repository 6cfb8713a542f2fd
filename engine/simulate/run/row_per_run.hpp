#pragma once

#include <memory>
#include <mutex>
#include <vector>

#include "engine/simulate/record/recorder.hpp"
#include "engine/simulate/run/pooling.hpp"
#include "engine/simulate/run/run_numbers.hpp"

namespace stepwire::run {

/// True if a sweep keeps one row of each run: the last one, or numbers computed from all rows. `numbers` may
/// be nullptr.
bool keeps_a_row(const Job& job, const RunNumbers* numbers);

/// Returns the recordings that are kept of a run, without rows and without columns of swept parameters. With
/// `numbers` it is one recording, else one for each request.
std::vector<record::Recording> empty_recordings(const plan::Plan& plan, const RunNumbers* numbers);
/// Returns the same for a point of a job. With `numbers`, a point whose rows are kept also has one recording
/// for each request.
std::vector<record::Recording> empty_recordings(const Job& job, std::size_t point, const RunNumbers* numbers);

/// Computes the row that a sweep keeps of a run and discards the others, except for runs whose rows are kept.
/// The row of a run that ended with a fault is NaN.
class RowMaker {
 public:
  /// The job, the columns and the numbers must outlive it.
  RowMaker(const Job& job, const SweptColumns& swept, const RunNumbers* numbers);

  /// Returns the recording of a run in progress, of a member. Thread-safe.
  std::unique_ptr<record::RunRecording> take(std::size_t member);
  /// Returns the row of a point in the form of empty_recordings(), and all rows of a run whose rows are kept.
  /// Thread-safe.
  std::vector<record::Recording> row_of(std::size_t point, bool whole,
                                        std::unique_ptr<record::RunRecording> recorded);

 private:
  std::vector<record::Recording> last_row(std::size_t point, bool whole,
                                          const std::vector<record::Recording>& run) const;
  std::vector<record::Recording> number_row(std::size_t point, bool whole,
                                            const std::vector<record::Recording>& run) const;

  const Job& job_;
  const SweptColumns& swept_;
  const RunNumbers* numbers_;
  std::mutex mutex_;
  std::vector<std::vector<std::unique_ptr<record::RunRecording>>> idle_;  ///< unused, by member
};

/// Rows of a sweep that keeps one row of each run, and all rows of some runs.
class RowPerRun {
 public:
  /// The job and the columns must outlive it.
  RowPerRun(const Job& job, const SweptColumns& swept, const RunNumbers* numbers);

  /// Stores the row of a point, and the recordings after it. Thread-safe.
  void put(std::size_t point, std::vector<record::Recording> row);
  /// Returns the rows of all completed runs in the order of the sweep, and after them the recordings of runs
  /// whose rows are kept. A missing one of these has no rows.
  std::vector<record::Recording> recordings();

 private:
  void drop_missing(record::Recording& kept) const;
  record::Recording pooled(std::size_t request);

  const Job& job_;
  const SweptColumns& swept_;
  std::vector<char> made_;  ///< True for completed points.
  std::vector<record::Recording> kept_;
  std::vector<std::size_t> recorded_points_;
  std::vector<std::vector<record::Recording>> recorded_;  ///< by point and request
};

}  // namespace stepwire::run
