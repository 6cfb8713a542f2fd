#pragma once

#include <memory>
#include <string>

#include "engine/app/session/fitting.hpp"
#include "engine/app/session/outcome.hpp"
#include "engine/app/session/studies.hpp"
#include "engine/app/session/tuning.hpp"
#include "engine/simulate/codegen/generated_code.hpp"
#include "engine/simulate/device/gpu_runs.hpp"
#include "engine/simulate/replay/verify.hpp"
#include "engine/simulate/run/code_trial.hpp"

namespace stepwire::session {

/// Operations of all user interfaces on diagram files. Each call returns data and reports the progress of
/// long operations to the monitor.
/// Calls throw Error for faults in a file and EnvironmentError for faults of its surroundings. They do not
/// print, end the process or depend on a terminal.
/// Compiled code and studies are shared between calls. Not thread-safe, except for study().
class Session {
 public:
  /// The registry must outlive the session and the models that it loads.
  explicit Session(const Registry& registry, Monitor monitor = {})
      : registry_(registry), monitor_(std::move(monitor)) {}

  const Registry& registry() const { return registry_; }
  /// Returns the monitor of later calls.
  Monitor& monitor() { return monitor_; }

  /// Loads and plans a file, and reads its figures, claims, fit, study and scene. It reports all faults that
  /// can be found before the first step.
  LoadedModel load(const std::string& file, const LoadOptions& options = {}) const;
  /// Sets the device on which later calls run the points of a sweep.
  void use_device(device::DeviceUse use);
  /// Runs a model, or all points of its sweep on `threads` threads (0: all cores), and judges its claims.
  Outcome run(const LoadedModel& model, run::ExecutionMode engine = run::ExecutionMode::automatic,
              unsigned threads = 0);
  /// Runs all points of the sweep and judges the claims run by run, without keeping rows in memory.
  Outcome pass(const LoadedModel& model, run::ExecutionMode engine = run::ExecutionMode::automatic,
               unsigned threads = 0);
  /// Runs the points of the sweep that an exchange names, on `threads` threads (0: all cores).
  PointsReport run(const LoadedModel& model, run::PointExchange& points,
                   run::ExecutionMode engine = run::ExecutionMode::automatic, unsigned threads = 0);
  /// Estimates the parameters of the model's section `fit`.
  estimation::FitResult fit(const LoadedModel& model, const FitCall& call = {});
  /// Returns the model reloaded with fitted values.
  LoadedModel fitted(const LoadedModel& model, const estimation::FitResult& result) const;
  /// Optimises the parameters of the model's section `tune`.
  tuning::TuneResult tune(const LoadedModel& model, const TuneCall& call = {});
  /// Returns the model reloaded with optimised values.
  LoadedModel tuned(const LoadedModel& model, const tuning::TuneResult& result) const;
  /// Performs the model's study, or returns the earlier result of the same study. study_outcome() converts it
  /// to an outcome.
  Studies::Shared study(const LoadedModel& model, const StudyCall& call = {});
  /// Replays the run in a folder and compares the results.
  replay::Verification replay(const std::string& folder) const;

 private:
  const Registry& registry_;
  Monitor monitor_;
  /// Reports why the processor has made runs of a sweep that were to be made on the GPU.
  void note_device(const run::LaneReport& report) const;

  codegen::GeneratedCode code_{run::code_trial()};
  device::DeviceUse device_use_ = device::DeviceUse::cpu;
  std::unique_ptr<device::GpuRuns> device_;  ///< nullptr for the processor
  Studies studies_;
};

}  // namespace stepwire::session
