#pragma once

#include <atomic>
#include <cstddef>
#include <optional>
#include <vector>

#include "engine/base/parallel/parallel.hpp"
#include "engine/simulate/run/point_exchange.hpp"
#include "engine/simulate/run/point_queue.hpp"
#include "engine/simulate/run/sweep_ends.hpp"
#include "engine/simulate/run/together_runs.hpp"

namespace stepwire::run {

/// Executor of points of a job: it holds the executors, the compiled code and the lanes that the points
/// share.
class PointRuns {
 public:
  /// Both must outlive it.
  PointRuns(const Job& job, const RunOptions& options);

  /// Returns the largest number of points with the plan of this one that run() takes at once.
  std::size_t at_once(std::size_t point) const { return together_.at_once(member_of(point)); }
  std::size_t member_of(std::size_t point) const { return job_.points[point].member; }
  /// Runs points of one member from time 0 to their ends. Thread-safe.
  void run(std::vector<PendingRun>& runs);
  bool interrupted() const { return options_.interrupt && *options_.interrupt; }
  LaneReport lanes() const;

 private:
  void run_alone(PendingRun& run, std::size_t member);

  const Job& job_;
  const RunOptions& options_;
  RunOptions own_;
  IdleRuns idle_;
  TieredExecution changeover_;
  TogetherRuns together_;
  std::atomic<std::size_t> done_ = 0;
};

/// Runs groups of points on each thread, until the function of make_take() returns an empty list. Function
/// `begin` makes the recording of each point, and `done` receives it after the run.
template <class MakeTake, class Begin, class Done>
void run_groups(PointRuns& runs, unsigned threads, const MakeTake& make_take, const Begin& begin,
                const Done& done) {
  parallel::on_threads(threads, [&] {
    auto take = make_take();
    for (auto points = take(); !points.empty(); points = take()) {
      std::vector<decltype(begin(0))> places;
      std::vector<PendingRun> group;
      for (const std::size_t point : points) places.push_back(begin(point));
      for (std::size_t i = 0; i < points.size(); ++i)
        group.push_back({points[i], nullptr, &places[i]->recorders(), {}});
      runs.run(group);
      for (std::size_t i = 0; i < points.size(); ++i) done(group[i], std::move(places[i]));
    }
  });
}

/// Source of all points of a job. Points that have not begun before an interruption have no results.
class AllPoints {
 public:
  AllPoints(const Job& job, const PointRuns& runs, SweepEnds& ends) : runs_(runs), ends_(ends), queue_(job) {}
  /// Returns the next points, of one member; an empty list at the end. Thread-safe.
  std::vector<std::size_t> take();

 private:
  std::vector<std::size_t> next();

  const PointRuns& runs_;
  SweepEnds& ends_;
  PointQueue queue_;
};

/// Source of points from an exchange, which groups successive points of one member. For one thread, which
/// leaves the exchange when this object is destroyed.
class ExchangedPoints {
 public:
  ExchangedPoints(const PointRuns& runs, PointExchange& exchange) : runs_(runs), exchange_(exchange) {}
  ~ExchangedPoints() { exchange_.leave(); }
  ExchangedPoints(const ExchangedPoints&) = delete;
  ExchangedPoints& operator=(const ExchangedPoints&) = delete;

  /// Call it after all points of the last call have been given to the exchange.
  std::vector<std::size_t> take();

 private:
  const PointRuns& runs_;
  PointExchange& exchange_;
  std::optional<std::size_t> waiting_;  ///< first point of another member
};

}  // namespace stepwire::run
