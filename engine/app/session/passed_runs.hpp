#pragma once

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

/// Names all points of a sweep, and passes what they give in their order.
class PointsInOrder : public run::PointExchange {
 public:
  explicit PointsInOrder(const LoadedModel& model)
      : points_(model.job.points.size()), passed_(model) {}

  std::optional<std::size_t> next() override;
  void take(run::PointResult result) override;
  double done() const override;
  /// Once all that was named is taken.
  Outcome outcome();

 private:
  const std::size_t points_;
  std::mutex mutex_;
  std::size_t named_ = 0, next_ = 0;
  std::atomic<std::size_t> taken_ = 0;
  std::map<std::size_t, run::PointResult> waiting_;  ///< behind one that is not there yet
  PassedRuns passed_;
};

}  // namespace stepwire::session
