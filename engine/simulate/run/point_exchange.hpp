#pragma once

#include <optional>
#include <vector>

#include "engine/simulate/run/row_per_run.hpp"
#include "engine/simulate/run/pooling.hpp"
#include "engine/simulate/run/run.hpp"
#include "engine/simulate/run/sweep_ends.hpp"

namespace stepwire::run {

/// What one point of a sweep has given.
struct PointResult {
  std::size_t point = 0;
  RunEnd end{};
  std::vector<record::Recording> recordings{};  ///< what is kept of it, without columns of what is swept
};

/// Where points of a sweep come from and their results go, each once: several calls, or machines, may share
/// the points.
class PointExchange {
 public:
  virtual ~PointExchange() = default;
  /// A point that is to be run; nothing once there is none any more. From any thread.
  virtual std::optional<std::size_t> next() = 0;
  /// Waits, on a thread that begins nothing meanwhile, until what others gave does not take too much memory for
  /// a further point. `held` is a point that next() has named and the thread has yet to run: it is not waited
  /// for. From any thread.
  virtual void wait_for_room(std::optional<std::size_t> /*held*/) {}
  /// Ends all waits for room, now and later: a thread takes no more points, and points that next() has named for
  /// it may stay without a result. From any thread.
  virtual void leave() {}
  /// What a point gave that next() has named; where its run was interrupted, what it gave until then. From
  /// any thread.
  virtual void take(PointResult result) = 0;
  /// How much of its points is done, 0 to 1, for people. From any thread.
  virtual double done() const = 0;
};

/// Runs points of a job until there are no more, or until it is interrupted.
LaneReport run_points(const Job& job, const RunOptions& options, PointExchange& exchange);

/// Joins what all points have given, in any order, to what run_job() gives. A point that is missing has no
/// rows.
class JoinedPoints {
 public:
  /// `numbers` are kept of each run in place of its rows, or null. Both must outlive it.
  JoinedPoints(const Job& job, const RunNumbers* numbers);
  void add(PointResult result);
  RunResult take();

 private:
  SweptColumns swept_;
  std::optional<PooledRecording> recording_;  ///< where all rows are kept
  std::optional<RowPerRun> kept_;              ///< where one row of each run is
  SweepEnds ends_;
};

}  // namespace stepwire::run
