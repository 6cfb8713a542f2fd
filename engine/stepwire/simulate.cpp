#include "engine/stepwire/simulate.hpp"

#include <fmt/format.h>

#include <atomic>
#include <map>
#include <mutex>

#include "engine/simulate/codegen/generated_code.hpp"
#include "engine/stepwire/content.hpp"

namespace stepwire {

namespace {

/// Shows the runs to an observer of a user.
class Shown : public RunObserver {
 public:
  Shown(const Model::Content& model, Observer& to) : model_(model), to_(to) {}

  void begin(const ObservedRun& run) override { to_.begin(running(run)); }
  Flow before_tick(const ObservedRun& run) override {
    Running now = running(run);
    return to_.before_tick(now);
  }
  void evaluated(const ObservedRun& run) override { to_.evaluated(running(run)); }
  void row(const ObservedRun& run, std::size_t recording, std::span<const double> numbers) override {
    to_.row(running(run), recording, numbers);
  }
  void end(const ObservedRun& run) override { to_.end(running(run)); }

 private:
  Running running(const ObservedRun& run) {
    return Running({model_, run.simulation, slots_of(run.simulation.plan()), run.index});
  }

  /// Points of a sweep may have plans of other structures, in which signals lie elsewhere.
  const std::vector<SignalSlot>& slots_of(const Plan& plan) {
    if (&plan == &model_.job.plan) return model_.slots;
    const std::lock_guard lock(mutex_);
    const auto known = slots_.find(&plan);
    return known != slots_.end() ? known->second : slots_.emplace(&plan, model_.slots_in(plan)).first->second;
  }

  const Model::Content& model_;
  Observer& to_;
  std::mutex mutex_;
  std::map<const Plan*, std::vector<SignalSlot>> slots_;
};

}  // namespace

Result simulate(const Model& model, const SimulateOptions& options) {
  std::atomic<bool> interrupt = false;
  const std::stop_callback stop(options.stop, [&] { interrupt = true; });
  std::vector<std::unique_ptr<Shown>> shown;
  GeneratedCode code;
  RunOptions run;
  run.interrupt = &interrupt;
  run.progress = options.progress;
  run.threads = options.threads;
  run.engine = options.engine;
  run.code = &code;
  for (Observer* observer : options.observers) {
    shown.push_back(std::make_unique<Shown>(model.content(), *observer));
    run.observers.push_back(shown.back().get());
  }
  RunResult result = run_job(model.content().job, run);
  return {std::move(result.recordings),
          std::move(result.faults),
          std::move(result.diagnostics),
          result.interrupted,
          result.ticks,
          result.compiled_ticks,
          code.take_problem()};
}

std::span<const double> Result::operator[](const std::string& column) const {
  std::vector<std::string> names;
  for (const Recording& recording : recordings) {
    if (const Column* found = recording.table.find(column)) return found->values;
    for (const Column& known : recording.table.columns) names.push_back(known.name);
  }
  throw Error(
      Fault{{}, column, fmt::format("nothing of this name is recorded{}", did_you_mean(column, names)), {}});
}

}  // namespace stepwire
