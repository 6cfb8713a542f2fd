#include "engine/simulate/run/point_runs.hpp"

#include <memory>
#include <utility>

namespace stepwire::run {

namespace {

std::vector<TieredExecution::Member> members_of(const Job& job) {
  std::vector<TieredExecution::Member> members;
  for (std::size_t m = 0; m < job.family->size(); ++m)
    members.push_back({&job.family->plan(m), job.family->variable(m)});
  return members;
}

double ticks_of(const Job& job) {
  double ticks = 0.0;
  for (std::size_t point = 0; point < job.points.size(); ++point)
    ticks += static_cast<double>(job.plan_of(point).steps);
  return ticks;
}

TogetherRuns::Members plans_of(const Job& job) {
  TogetherRuns::Members plans;
  for (std::size_t m = 0; m < job.family->size(); ++m)
    plans.push_back({&job.family->plan(m), {job.family->variable(m), job.family->targets(m)}, 0});
  for (const SweepPoint& point : job.points) ++*plans[point.member].runs;
  return plans;
}

LaneUse use_of(const RunOptions& options) {
  const bool alone = options.engine == ExecutionMode::interpreted || !options.observers.empty();
  return alone ? LaneUse::never : options.lanes;
}

}  // namespace

PointRuns::PointRuns(const Job& job, const RunOptions& options)
    : job_(job),
      options_(options),
      idle_(*job.family),
      changeover_(options.engine, options.code, members_of(job), ticks_of(job)),
      together_(plans_of(job), use_of(options), options.code, options.interrupt) {
  own_.interrupt = options.interrupt;
  own_.observers = options.observers;
}

void PointRuns::run(std::vector<PendingRun>& runs) {
  const std::size_t member = member_of(runs.front().index);
  std::vector<std::unique_ptr<Executor>> simulations;
  for (PendingRun& run : runs) {
    run.simulation = simulations.emplace_back(idle_.take(member)).get();
    job_.family->begin(member, job_.settings_of(run.index), *run.simulation);
  }
  if (!together_.run(member, changeover_.code(member), runs))
    for (PendingRun& run : runs) run_alone(run, member);
  for (auto& simulation : simulations) idle_.give_back(member, std::move(simulation));
  const double done = static_cast<double>(done_ += runs.size());
  if (options_.progress) options_.progress(done / static_cast<double>(job_.points.size()));
}

void PointRuns::run_alone(PendingRun& run, std::size_t member) {
  run.end = run_simulation(*run.simulation, *run.recorders, own_, changeover_, member, run.index);
  together_.done(run.end.ticks);
}

LaneReport PointRuns::lanes() const {
  LaneReport report = together_.report();
  if (!options_.observers.empty()) report.why_not = "observers watch the runs";
  return report;
}

std::vector<std::size_t> AllPoints::take() {
  auto points = next();
  for (; runs_.interrupted() && !points.empty(); points = next())
    for (const std::size_t point : points) {
      RunEnd end;
      end.interrupted = true;
      ends_.add(point, std::move(end));
    }
  return points;
}

std::vector<std::size_t> AllPoints::next() {
  return queue_.take([this](std::size_t first) { return runs_.at_once(first); });
}

std::vector<std::size_t> ExchangedPoints::take() {
  std::vector<std::size_t> points;
  exchange_.wait_for_room(waiting_);
  if (runs_.interrupted()) return points;
  auto point = waiting_ ? std::exchange(waiting_, std::nullopt) : exchange_.next();
  for (; point; point = exchange_.next()) {
    if (!points.empty() && runs_.member_of(*point) != runs_.member_of(points.front())) break;
    points.push_back(*point);
    if (points.size() >= runs_.at_once(points.front())) return points;
  }
  waiting_ = point;
  return points;
}

}  // namespace stepwire::run
