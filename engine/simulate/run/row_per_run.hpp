#pragma once

#include <memory>
#include <mutex>
#include <vector>

#include "engine/simulate/record/recorder.hpp"
#include "engine/simulate/run/pooling.hpp"
#include "engine/simulate/run/run_numbers.hpp"

namespace stepwire::run {

/// Does a sweep keep one row of each run: the last recorded one, or numbers (which may be null) that are made
/// of all rows?
bool keeps_a_row(const Job& job, const RunNumbers* numbers);

/// What a run of a plan keeps, as recordings without rows and without columns of what is swept: one where
/// numbers are kept, else one for each request.
std::vector<record::Recording> empty_recordings(const plan::Plan& plan, const RunNumbers* numbers);
/// The same for a point of a job; beside numbers also one for each request where the point is recorded.
std::vector<record::Recording> empty_recordings(const Job& job, std::size_t point, const RunNumbers* numbers);

/// Makes the row that a sweep keeps of a run, and forgets the others, but for runs whose rows stay. A run
/// that a fault ended has a row of nan.
class RowMaker {
 public:
  /// Job, columns and numbers must outlive it.
  RowMaker(const Job& job, const SweptColumns& swept, const RunNumbers* numbers);

  /// What a run of a member records while it goes on; from any thread.
  std::unique_ptr<record::RunRecording> take(std::size_t member);
  /// The row of a point, and all rows of a run whose rows stay, in empty_recordings(); from any thread.
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
  std::vector<std::vector<std::unique_ptr<record::RunRecording>>> idle_;  ///< of each member
};

/// The rows of a sweep that keeps one of each run, and of some runs all.
class RowPerRun {
 public:
  /// Job and columns must outlive it.
  RowPerRun(const Job& job, const SweptColumns& swept, const RunNumbers* numbers);

  /// Keeps the row of a point, and its recordings behind that; from any thread.
  void put(std::size_t point, std::vector<record::Recording> row);
  /// The rows of all runs that were made, in the order of the sweep, and behind them the recordings of those
  /// whose rows stay. Of these one that is missing has no rows.
  std::vector<record::Recording> recordings();

 private:
  void drop_missing(record::Recording& kept) const;
  record::Recording pooled(std::size_t request);

  const Job& job_;
  const SweptColumns& swept_;
  std::vector<char> made_;  ///< of each point
  std::vector<record::Recording> kept_;
  std::vector<std::size_t> recorded_points_;
  std::vector<std::vector<record::Recording>> recorded_;  ///< of each of these points, one for each request
};

}  // namespace stepwire::run
