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
class Shown : public run::RunObserver {
 public:
  Shown(const Model::Content& model, Observer& to) : model_(model), to_(to) {}

  void begin(const run::ObservedRun& run) override { to_.begin(running(run)); }
  run::Flow before_tick(const run::ObservedRun& run) override {
    Running now = running(run);
    return to_.before_tick(now);
  }
  void evaluated(const run::ObservedRun& run) override { to_.evaluated(running(run)); }
  void row(const run::ObservedRun& run, std::size_t recording, std::span<const double> numbers) override {
    to_.row(running(run), recording, numbers);
  }
  void end(const run::ObservedRun& run) override { to_.end(running(run)); }

 private:
  Running running(const run::ObservedRun& run) {
    return Running({model_, run.simulation, slots_of(run.simulation.plan()), run.index});
  }

  /// Points of a sweep may have plans of other structures, in which signals lie elsewhere.
  const std::vector<plan::SignalSlot>& slots_of(const plan::Plan& plan) {
    if (&plan == &model_.job.plan) return model_.slots;
    const std::lock_guard lock(mutex_);
    const auto known = slots_.find(&plan);
    return known != slots_.end() ? known->second : slots_.emplace(&plan, model_.slots_in(plan)).first->second;
  }

  const Model::Content& model_;
  Observer& to_;
  std::mutex mutex_;
  std::map<const plan::Plan*, std::vector<plan::SignalSlot>> slots_;
};

}  // namespace

Result simulate(const Model& model, const SimulateOptions& options) {
  std::atomic<bool> interrupt = false;
  const std::stop_callback stop(options.stop, [&] { interrupt = true; });
  std::vector<std::unique_ptr<Shown>> shown;
  codegen::GeneratedCode code;
  run::RunOptions run;
  run.interrupt = &interrupt;
  run.progress = options.progress;
  run.threads = options.threads;
  run.engine = options.engine;
  run.code = &code;
  for (Observer* observer : options.observers) {
    shown.push_back(std::make_unique<Shown>(model.content(), *observer));
    run.observers.push_back(shown.back().get());
  }
  run::RunResult result = run::run_job(model.content().job, run);
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
  for (const record::Recording& recording : recordings) {
    if (const table::Column* found = recording.table.find(column)) return found->values;
    for (const table::Column& known : recording.table.columns) names.push_back(known.name);
  }
  throw yaml::Error(
      yaml::Fault{{}, column, "nothing of this name is recorded" + yaml::did_you_mean(column, names), {}});
}

}  // namespace stepwire
