#pragma once

#include <memory>
#include <mutex>
#include <vector>

#include "engine/simulate/record/recorder.hpp"
#include "engine/simulate/run/pooling.hpp"
#include "engine/simulate/run/run_numbers.hpp"

namespace stepwire::run {

/// What a sweep keeps that keeps one row of each run: the last recorded one, or numbers that are made of all
/// rows, which are then forgotten. A run that a fault ended has a row of nan behind its swept parameters.
class KeptRows {
 public:
  /// `numbers` are made of a run; null: the last rows are kept. Job, columns and numbers must outlive it.
  KeptRows(const Job& job, const SweptColumns& swept, const RunNumbers* numbers);

  /// What a run of a member records while it goes on; from any thread.
  std::unique_ptr<record::RunRecording> take(std::size_t member);
  /// Keeps the row of a point; from any thread.
  void done(std::size_t point, bool whole, std::unique_ptr<record::RunRecording> recorded);
  /// The rows of all runs that were made, in the order of the sweep.
  std::vector<record::Recording> recordings();

 private:
  void keep_last(std::size_t point, bool whole, const std::vector<record::Recording>& run);
  void keep_numbers(std::size_t point, bool whole, const std::vector<record::Recording>& run);
  void begin_row(record::Recording& kept, std::size_t point) const;
  void drop_missing(record::Recording& kept) const;

  const Job& job_;
  const SweptColumns& swept_;
  const RunNumbers* numbers_;
  std::vector<char> made_;  ///< of each point
  std::vector<record::Recording> kept_;
  std::mutex mutex_;
  std::vector<std::vector<std::unique_ptr<record::RunRecording>>> idle_;  ///< of each member
};

}  // namespace stepwire::run
