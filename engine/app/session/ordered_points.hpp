#pragma once

#include <atomic>
#include <condition_variable>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "engine/app/session/outcome.hpp"
#include "engine/app/session/signal_files.hpp"

namespace stepwire::session {

/// Outputs of a call that need rows of a sweep's runs. Claims are not included.
struct RowUse {
  std::string folder{};  ///< folder of pictures and files; empty: none
  FileKinds files{};     ///< kinds of signal files in the folder
  bool table = false;    ///< one text table of all rows
};

/// True if the runs can be processed one by one in order, so that their rows need not stay in memory.
bool goes_run_by_run(const LoadedModel& model, const RowUse& use);

/// Throws Error with the place of each output that needs the rows of all runs at once, if these exceed the
/// free memory.
void require_rows(const LoadedModel& model, const RowUse& use);

/// Rows of the runs that figures read.
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

/// Consumer of the runs of a sweep in order. Each run is judged and written to the files of runs; then its
/// rows are discarded.
class StreamingJudge {
 public:
  /// Opens the files. Throws EnvironmentError.
  explicit StreamingJudge(const LoadedModel& model, const RowUse& use = {});

  /// Adds a run, in ascending order of points. Skipped points count as runs without rows. Throws
  /// EnvironmentError.
  void add(run::PointResult result);
  /// Judges the claims and finishes the files.
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
  std::vector<std::vector<std::unique_ptr<RunFile>>> files_;  ///< by recording
  std::size_t next_ = 0;
  bool misses_ = false;  ///< true after a skipped run
};

/// Exchange that names all points of a sweep and passes their results to StreamingJudge in order.
/// Threads finish points out of order, so results wait until all earlier ones are passed. To bound the
/// memory, a thread begins no further point while the waiting results exceed a limit. The thread that has the
/// next point in order never waits, so there is no deadlock.
class OrderedPoints : public run::PointExchange {
 public:
  /// `most_waiting` is the limit of waiting results [bytes].
  explicit OrderedPoints(const LoadedModel& model, std::size_t most_waiting = std::size_t{64} << 20)
      : points_(model.job.points.size()), most_waiting_(most_waiting), passed_(model) {}

  std::optional<std::size_t> next() override;
  void wait_for_room(std::optional<std::size_t> held) override;
  void leave() override;
  void take(run::PointResult result) override;
  double done() const override;
  /// Returns the outcome, after the results of all named points.
  Outcome outcome();
  /// Returns the largest size of waiting results so far [bytes].
  std::size_t peak() const;

 private:
  const std::size_t points_, most_waiting_;
  mutable std::mutex mutex_;
  std::condition_variable moved_;
  bool left_ = false;  ///< a thread has left, so no thread waits any more
  std::size_t named_ = 0, next_ = 0, bytes_ = 0, peak_ = 0;
  std::atomic<std::size_t> taken_ = 0;
  std::map<std::size_t, run::PointResult> waiting_;  ///< results whose predecessors are missing
  StreamingJudge passed_;
};

}  // namespace stepwire::session
