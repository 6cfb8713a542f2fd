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

/// Runs points of a job, and shares between them what they can share.
class PointRuns {
 public:
  /// Both must outlive it.
  PointRuns(const Job& job, const RunOptions& options);

  /// How many points of the plan of this one are to be given to run(), at most.
  std::size_t at_once(std::size_t point) const { return together_.at_once(member_of(point)); }
  std::size_t member_of(std::size_t point) const { return job_.points[point].member; }
  /// Runs points of one member to their ends, which begin here. From any thread.
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

/// On each thread, until make_take()'s function names no points any more: has `begin` make a place for what
/// each of them records, runs them, and hands them to `done`.
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

/// Names all points of a job; nothing is kept of what has not begun before an interruption.
class AllPoints {
 public:
  AllPoints(const Job& job, const PointRuns& runs, SweepEnds& ends) : runs_(runs), ends_(ends), queue_(job) {}
  /// The next points, of one member; none at the end. From any thread.
  std::vector<std::size_t> take();

 private:
  std::vector<std::size_t> next();

  const PointRuns& runs_;
  SweepEnds& ends_;
  PointQueue queue_;
};

/// Names points of an exchange, those of one member that come one after the other together. Of one thread, which
/// leaves the exchange with it.
class ExchangedPoints {
 public:
  ExchangedPoints(const PointRuns& runs, PointExchange& exchange) : runs_(runs), exchange_(exchange) {}
  ~ExchangedPoints() { exchange_.leave(); }
  ExchangedPoints(const ExchangedPoints&) = delete;
  ExchangedPoints& operator=(const ExchangedPoints&) = delete;

  /// Called once all points of the last call have been given to the exchange.
  std::vector<std::size_t> take();

 private:
  const PointRuns& runs_;
  PointExchange& exchange_;
  std::optional<std::size_t> waiting_;  ///< the first of another member
};

}  // namespace stepwire::run
