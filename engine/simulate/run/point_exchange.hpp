#pragma once

#include <atomic>
#include <optional>
#include <vector>

#include "engine/simulate/run/pooling.hpp"
#include "engine/simulate/run/row_per_run.hpp"
#include "engine/simulate/run/run.hpp"
#include "engine/simulate/run/sweep_ends.hpp"

namespace stepwire::run {

/// Result of one point of a sweep.
struct PointResult {
  std::size_t point = 0;
  RunEnd end{};
  std::vector<record::Recording> recordings{};  ///< of the point, without columns of swept parameters
  std::vector<std::size_t> rows{};  ///< numbers of rows that PointExchange::recorders() have written
};

/// Source of the points of a sweep and sink of their results, each once: results in memory, in a journal, or
/// passed on in order. Several calls or machines may share the points.
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
  /// Returns recorders that write the rows of a point to their final place; none if the result of the point
  /// is to contain its rows. Thread-safe.
  virtual std::vector<record::Recorder> recorders(std::size_t /*point*/) { return {}; }
  /// Stores the result of a point that next() returned; after an interruption, the result up to then.
  /// Thread-safe.
  virtual void take(PointResult result) = 0;
  /// Returns the fraction of the points that is done, 0 to 1, for display. Thread-safe.
  virtual double done() const = 0;
};

/// Runs points of a job until none is left, or until it is interrupted.
LaneReport run_points(const Job& job, const RunOptions& options, PointExchange& exchange);

/// Exchange that names all points of a sweep and merges their results in memory, in any order. A missing
/// point has no rows.
class JoinedPoints : public PointExchange {
 public:
  /// Numbers of the options replace the rows of each run. Job and numbers must outlive this object.
  JoinedPoints(const Job& job, const RunOptions& options);

  std::optional<std::size_t> next() override;
  std::vector<record::Recorder> recorders(std::size_t point) override;
  void take(PointResult result) override;
  double done() const override;
  /// Returns the result of run_job(), after the results of all points.
  RunResult result();

 private:
  std::vector<std::size_t> order_;  ///< points as next() returns them
  SweptColumns swept_;
  std::optional<PooledRecording> recording_;  ///< used if all rows are kept
  std::optional<RowPerRun> kept_;             ///< used if one row of each run is kept
  SweepEnds ends_;
  std::atomic<std::size_t> next_ = 0, taken_ = 0, whole_ = 0;
};

}  // namespace stepwire::run
