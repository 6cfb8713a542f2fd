#pragma once

#include <map>
#include <mutex>
#include <vector>

#include "engine/simulate/run/observer.hpp"
#include "engine/stepwire/content.hpp"
#include "engine/stepwire/observer.hpp"

namespace stepwire {

/// Adapter that passes the runs of a model to an observer of the public interface. Both must outlive it.
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

  /// Returns the slots of the signals in a plan. Points of a sweep may have plans of other structures, with
  /// other slots.
  const std::vector<plan::SignalSlot>& slots_of(const plan::Plan& plan) {
    if (&plan == &model_.job->plan) return model_.slots;
    const std::lock_guard lock(mutex_);
    const auto known = slots_.find(&plan);
    return known != slots_.end() ? known->second : slots_.emplace(&plan, model_.slots_in(plan)).first->second;
  }

  const Model::Content& model_;
  Observer& to_;
  std::mutex mutex_;
  std::map<const plan::Plan*, std::vector<plan::SignalSlot>> slots_;
};

}  // namespace stepwire
