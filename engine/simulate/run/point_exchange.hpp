#pragma once

#include <optional>
#include <vector>

#include "engine/simulate/run/row_per_run.hpp"
#include "engine/simulate/run/pooling.hpp"
#include "engine/simulate/run/run.hpp"
#include "engine/simulate/run/sweep_ends.hpp"

namespace stepwire::run {

/// Result of one point of a sweep.
struct PointResult {
  std::size_t point = 0;
  RunEnd end{};
  std::vector<record::Recording> recordings{};  ///< of the point, without columns of swept parameters
};

/// Source of the points of a sweep and sink of their results, each once. Several calls or machines may share
/// the points.
class PointExchange {
 public:
  virtual ~PointExchange() = default;
  /// Returns a point to run; std::nullopt after the last one. Thread-safe.
  virtual std::optional<std::size_t> next() = 0;
  /// Blocks until the results in memory leave room for a further point. The thread begins no run meanwhile.
  /// The point `held` is a point that next() has returned and that the thread has yet to run; the wait
  /// excludes it. Thread-safe.
  virtual void wait_for_room(std::optional<std::size_t> /*held*/) {}
  /// Ends all waits for room, now and later. The thread takes no further points, and points that next() has
  /// returned to it may stay without a result. Thread-safe.
  virtual void leave() {}
  /// Stores the result of a point that next() returned; after an interruption, the result up to then.
  /// Thread-safe.
  virtual void take(PointResult result) = 0;
  /// Returns the fraction of the points that is done, 0 to 1, for display. Thread-safe.
  virtual double done() const = 0;
};

/// Runs points of a job until none is left, or until it is interrupted.
LaneReport run_points(const Job& job, const RunOptions& options, PointExchange& exchange);

/// Merges the results of all points, in any order, into the result of run_job(). A missing point has no rows.
class JoinedPoints {
 public:
  /// `numbers` replace the rows of each run; nullptr keeps rows. Both must outlive this object.
  JoinedPoints(const Job& job, const RunNumbers* numbers);
  void add(PointResult result);
  RunResult take();

 private:
  SweptColumns swept_;
  std::optional<PooledRecording> recording_;  ///< used if all rows are kept
  std::optional<RowPerRun> kept_;  ///< used if one row of each run is kept
  SweepEnds ends_;
};

}  // namespace stepwire::run
