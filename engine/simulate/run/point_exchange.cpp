#include "engine/simulate/run/point_exchange.hpp"

#include <algorithm>
#include <memory>
#include <numeric>
#include <span>
#include <utility>

#include "engine/base/parallel/parallel.hpp"
#include "engine/simulate/run/run_pool.hpp"

namespace stepwire::run {

namespace {

PoolWork work_of(const Job& job, const RunOptions& options) {
  const bool keeps_rows = options.numbers != nullptr || !keeps_a_row(job, nullptr);
  PoolWork work{0.0, std::vector<std::size_t>(job.family->size()), keeps_rows};
  for (std::size_t point = 0; point < job.points.size(); ++point) {
    work.ticks += static_cast<double>(job.plan_of(point).steps);
    ++work.runs[job.points[point].member];
  }
  return work;
}

/// Points that share a plan follow each other, so that lanes can take them together, and keep near their
/// place in the sweep. With observers the order is that of the sweep.
std::vector<std::size_t> order_of(const Job& job, const RunOptions& options) {
  const std::size_t reach = options.device ? 65'536 : 512;
  std::vector<std::size_t> order(job.points.size());
  std::iota(order.begin(), order.end(), 0);
  if (!options.observers.empty()) return order;
  for (std::size_t first = 0; first < order.size(); first += reach)
    std::ranges::stable_sort(std::span(order).subspan(first, std::min(reach, order.size() - first)), {},
                             [&](std::size_t point) { return job.points[point].member; });
  return order;
}

/// Points of an exchange for one thread, in groups of successive points of one member. The thread leaves the
/// exchange when this object is destroyed.
class PointGroups {
 public:
  PointGroups(const Job& job, const RunPool& pool, PointExchange& exchange)
      : job_(job), pool_(pool), exchange_(exchange) {}
  ~PointGroups() { exchange_.leave(); }
  PointGroups(const PointGroups&) = delete;
  PointGroups& operator=(const PointGroups&) = delete;

  /// Returns the next group; an empty list at the end. Call it after all points of the last group have been
  /// given to the exchange.
  std::vector<std::size_t> next() {
    std::vector<std::size_t> points;
    exchange_.wait_for_room(waiting_);
    if (pool_.interrupted()) return points;
    auto point = waiting_ ? std::exchange(waiting_, std::nullopt) : exchange_.next();
    for (; point; point = exchange_.next()) {
      if (!points.empty() && member_of(*point) != member_of(points.front())) break;
      points.push_back(*point);
      if (points.size() >= pool_.at_once(member_of(points.front()))) return points;
    }
    waiting_ = point;
    return points;
  }

 private:
  std::size_t member_of(std::size_t point) const { return job_.points[point].member; }

  const Job& job_;
  const RunPool& pool_;
  PointExchange& exchange_;
  std::optional<std::size_t> waiting_;  ///< first point of another member
};

/// Runs of points, from several threads.
class PointRuns {
 public:
  PointRuns(const Job& job, const RunOptions& options, PointExchange& exchange)
      : job_(job),
        options_(options),
        exchange_(exchange),
        swept_(job),
        rows_(job, swept_, options.numbers),
        pool_(*job.family, options, work_of(job, options)) {}

  /// Runs points in the calling thread until none is left.
  void work() {
    PointGroups groups(job_, pool_, exchange_);
    for (auto points = groups.next(); !points.empty(); points = groups.next()) {
      run(points);
      if (options_.progress) options_.progress(exchange_.done());
    }
  }

  LaneReport lanes() const { return pool_.lanes(); }

 private:
  /// Rows of a point: at their final place, or in a recording of their own.
  struct Rows {
    std::vector<record::Recorder> in_place;
    std::unique_ptr<record::RunRecording> own;
    std::vector<record::Recorder>& recorders() { return own ? own->recorders() : in_place; }
  };

  void run(const std::vector<std::size_t>& points) {
    const std::size_t member = job_.points[points.front()].member;
    std::vector<Rows> rows;
    std::vector<PendingRun> runs;
    for (const std::size_t point : points) {
      Rows& own = rows.emplace_back(Rows{exchange_.recorders(point), nullptr});
      if (own.in_place.empty()) own.own = rows_.take(member);
    }
    for (std::size_t i = 0; i < points.size(); ++i)
      runs.push_back({points[i], nullptr, &rows[i].recorders(), {}});
    pool_.run(
        member, [this](std::size_t point) { return job_.settings_of(point); }, runs);
    for (std::size_t i = 0; i < points.size(); ++i) exchange_.take(result_of(runs[i], std::move(rows[i])));
  }

  PointResult result_of(PendingRun& run, Rows rows) {
    PointResult result{run.index, std::move(run.end)};
    for (const record::Recorder& recorder : rows.in_place) result.rows.push_back(recorder.rows());
    if (!rows.own) return result;
    if (!keeps_a_row(job_, options_.numbers))
      result.recordings = rows.own->take();
    else if (!result.end.interrupted)
      result.recordings = rows_.row_of(run.index, result.end.faults.empty(), std::move(rows.own));
    return result;
  }

  const Job& job_;
  const RunOptions& options_;
  PointExchange& exchange_;
  const SweptColumns swept_;
  RowMaker rows_;
  RunPool pool_;
};

}  // namespace

LaneReport run_points(const Job& job, const RunOptions& options, PointExchange& exchange) {
  PointRuns runs(job, options, exchange);
  parallel::on_threads(options.threads, [&] { runs.work(); });
  return runs.lanes();
}

JoinedPoints::JoinedPoints(const Job& job, const RunOptions& options)
    : order_(order_of(job, options)), swept_(job), ends_(job) {
  if (keeps_a_row(job, options.numbers))
    kept_.emplace(job, swept_, options.numbers);
  else
    recording_.emplace(job, swept_, options.threads);
}

std::optional<std::size_t> JoinedPoints::next() {
  const std::size_t place = next_++;
  return place < order_.size() ? std::optional(order_[place]) : std::nullopt;
}

std::vector<record::Recorder> JoinedPoints::recorders(std::size_t point) {
  return recording_ ? recording_->recorders(point) : std::vector<record::Recorder>{};
}

void JoinedPoints::take(PointResult result) {
  if (recording_)
    recording_->put(result.point, result.recordings, result.rows);
  else if (!result.end.interrupted)
    kept_->put(result.point, std::move(result.recordings));
  whole_ += !result.end.interrupted;
  ends_.add(result.point, std::move(result.end));
  ++taken_;
}

double JoinedPoints::done() const {
  return static_cast<double>(taken_) / static_cast<double>(order_.size());
}

RunResult JoinedPoints::result() {
  RunResult result{ends_.take(), kept_ ? kept_->recordings() : recording_->take(), {}};
  result.interrupted = whole_ < order_.size();
  return result;
}

}  // namespace stepwire::run
