#pragma once

#include <atomic>
#include <condition_variable>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "engine/app/session/outcome.hpp"
#include "engine/app/session/row_use.hpp"

namespace stepwire::session {

/// The rows of runs that figures read, those of each run alone.
class DrawnRows {
 public:
  explicit DrawnRows(const LoadedModel& model) : model_(model) {}
  void add(const std::vector<record::Recording>& run);
  std::vector<record::Recording> take() { return std::move(rows_); }

 private:
  std::size_t first_drawn(const std::vector<record::Recording>& run, std::size_t recording) const;

  const LoadedModel& model_;
  std::vector<record::Recording> rows_;
};

/// Looks at the runs of a sweep one by one, in their order, and forgets their rows: claims judge them, files
/// of runs take them.
class PassedRuns {
 public:
  /// Throws EnvironmentError.
  explicit PassedRuns(const LoadedModel& model, const RowUse& use = {});

  /// A run behind those that were added; one between that is not added has no rows. Throws EnvironmentError.
  void add(run::PointResult result);
  /// Judges, and ends the files.
  Outcome take();

 private:
  void pass(std::vector<record::Recording> run);
  void pass_missing(std::size_t end);

  const LoadedModel& model_;
  run::SweptColumns swept_;
  run::SweepEnds ends_;
  RunJudges judges_;
  DrawnRows drawn_;
  bool draws_;
  std::vector<std::vector<std::unique_ptr<RunFile>>> files_;  ///< [recording]
  std::size_t next_ = 0;
  bool misses_ = false;  ///< a run that was not added
};

/// Names all points of a sweep, and passes what they give in their order. What points behind the next one gave
/// waits for it; where this takes too much memory, no thread begins a further point. It ends in any case: the
/// next one is named, and no thread that waits has it.
class PointsInOrder : public run::PointExchange {
 public:
  /// A thread begins a point where no more than `most_waiting` bytes wait.
  explicit PointsInOrder(const LoadedModel& model, std::size_t most_waiting = std::size_t{64} << 20)
      : points_(model.job.points.size()), most_waiting_(most_waiting), passed_(model) {}

  std::optional<std::size_t> next() override;
  void wait_for_room(std::optional<std::size_t> held) override;
  void leave() override;
  void take(run::PointResult result) override;
  double done() const override;
  /// Once all that was named is taken.
  Outcome outcome();
  /// The most that has waited [bytes].
  std::size_t peak() const;

 private:
  const std::size_t points_, most_waiting_;
  mutable std::mutex mutex_;
  std::condition_variable moved_;
  bool left_ = false;  ///< by a thread
  std::size_t named_ = 0, next_ = 0, bytes_ = 0, peak_ = 0;
  std::atomic<std::size_t> taken_ = 0;
  std::map<std::size_t, run::PointResult> waiting_;  ///< behind one that is not there yet
  PassedRuns passed_;
};

}  // namespace stepwire::session
