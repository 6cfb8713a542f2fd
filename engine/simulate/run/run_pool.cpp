#include "engine/simulate/run/run_pool.hpp"

#include <algorithm>
#include <iterator>
#include <thread>
#include <utility>

namespace stepwire::run {

namespace {

LaneUse use_of(const RunOptions& options) {
  const bool alone = options.engine == ExecutionMode::interpreted || !options.observers.empty();
  return alone ? LaneUse::never : options.lanes;
}

/// Opens the device of the options, unless observers watch the runs.
std::unique_ptr<DeviceRuns> device_of(const RunOptions& options, const std::vector<PlanOfRuns>& members,
                                      bool keeps_rows) {
  if (!options.device || !options.observers.empty()) return nullptr;
  const unsigned threads = options.threads > 0 ? options.threads : std::thread::hardware_concurrency();
  return options.device->open(members, {options.interrupt, std::max(1u, threads), keeps_rows});
}

}  // namespace

PooledRun::PooledRun(RunPool& pool, std::shared_ptr<const plan::Plan> plan)
    : pool_(&pool), own_(std::move(plan)), simulation_(std::make_unique<Executor>(*own_)) {}

PooledRun::~PooledRun() {
  if (simulation_ && !own_) pool_->give_back(member_, std::move(simulation_));
}

RunPool::RunPool(const PlanFamily& family, RunOptions options, const PoolWork& work)
    : family_(family),
      options_(std::move(options)),
      device_(device_of(options_, family.plans_of_runs(work.runs), work.keeps_rows)),
      code_(options_.engine, options_.code, family.plans_of_runs(work.runs), work.ticks),
      lanes_(family.plans_of_runs(work.runs), use_of(options_), options_.code, options_.interrupt) {}

PooledRun RunPool::begin(std::size_t member, const std::vector<diagram::Setting>& values) {
  {
    PooledRun run(*this, member, take(member));
    if (family_.set(member, values, run.simulation())) return run;
  }
  return begin_anew(member, values);
}

PooledRun RunPool::begin_anew(std::size_t member, const std::vector<diagram::Setting>& values) {
  return {*this, family_.plan_anew(member, values)};
}

RunResult RunPool::run(const PooledRun& run, std::size_t index, RunObserver* observer) {
  record::RunRecording recording(run.simulation().plan());
  PendingRun pending{index, &run.simulation(), &recording.recorders()};
  const std::size_t member = run.member();
  if (observer || !lanes_.run(member, code_.code(member), pending)) run_alone(member, pending, observer);
  return {std::move(pending.end), recording.take(), {}};
}

void RunPool::run(std::size_t member, const PlanFamily::ValuesOfRun& values_of,
                  std::vector<PendingRun>& runs) {
  std::vector<PooledRun> begun;
  for (PendingRun& run : runs) {
    begun.push_back(begin(member, values_of(run.index)));
    run.simulation = &begun.back().simulation();
  }
  const bool alike = std::ranges::none_of(begun, &PooledRun::has_own_plan);
  if (alike && device_ && device_->at_once(member) > 0 && device_->run(member, runs)) return;
  const std::size_t at_once = lanes_.runner().at_once(member);
  for (std::size_t first = 0; alike && first < runs.size(); first += at_once)
    run_here(member, std::span(runs).subspan(first, std::min(at_once, runs.size() - first)));
  for (std::size_t i = 0; !alike && i < runs.size(); ++i) run_alone(begun[i].member(), runs[i]);
}

void RunPool::run_here(std::size_t member, std::span<PendingRun> runs) {
  std::vector<PendingRun> together(std::make_move_iterator(runs.begin()),
                                   std::make_move_iterator(runs.end()));
  if (!lanes_.runner().run(member, code_.code(member), together))
    for (PendingRun& run : together) run_alone(member, run);
  std::ranges::move(together, runs.begin());
}

void RunPool::run_alone(std::size_t member, PendingRun& run, RunObserver* observer) {
  RunOptions own;
  own.interrupt = options_.interrupt;
  own.observers = options_.observers;
  if (observer) own.observers.push_back(observer);
  own.shows_rows = options_.shows_rows;
  run.end = run_simulation(*run.simulation, *run.recorders, own, code_, member, run.index);
  lanes_.done(run.end.ticks);
}

std::size_t RunPool::at_once(std::size_t member) const {
  const std::size_t on_device = device_ ? device_->at_once(member) : 0;
  return on_device > 0 ? on_device : lanes_.runner().at_once(member);
}

bool RunPool::compiled() const {
  if (options_.engine == ExecutionMode::interpreted) return false;
  for (std::size_t member = 0; member < family_.size(); ++member)
    if (!code_.code(member)) return false;
  return true;
}

LaneReport RunPool::lanes() const {
  LaneReport report = lanes_.lanes();
  if (!options_.observers.empty()) report.why_not = "observers watch the runs";
  if (device_)
    report.device = device_->report();
  else if (options_.device)
    report.device.why_not = "observers watch the runs";
  return report;
}

std::unique_ptr<Executor> RunPool::take(std::size_t member) {
  {
    const std::lock_guard lock(mutex_);
    idle_.resize(family_.size());
    if (!idle_[member].empty()) {
      auto simulation = std::move(idle_[member].back());
      idle_[member].pop_back();
      return simulation;
    }
  }
  return std::make_unique<Executor>(family_.plan(member));
}

void RunPool::give_back(std::size_t member, std::unique_ptr<Executor> simulation) {
  const std::lock_guard lock(mutex_);
  idle_[member].push_back(std::move(simulation));
}

}  // namespace stepwire::run
