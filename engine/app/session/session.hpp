#pragma once

#include <memory>
#include <string>

#include "engine/app/session/fitting.hpp"
#include "engine/app/session/outcome.hpp"
#include "engine/app/session/studies.hpp"
#include "engine/app/session/tuning.hpp"
#include "engine/simulate/codegen/generated_code.hpp"
#include "engine/simulate/replay/verify.hpp"
#include "engine/simulate/run/code_trial.hpp"

namespace stepwire::session {

/// What the doors to the engine do with diagram files: each call returns data, throws Error for what is wrong
/// in a file and EnvironmentError for what is wrong around it, and shows what takes long to the monitor.
/// Nothing here prints, ends the process or knows a terminal. What calls can share (compiled code, studies)
/// is kept between them. One thread at a time, but for study().
class Session {
 public:
  /// The registry must outlive the session and the models that it loads.
  explicit Session(const Registry& registry, Monitor monitor = {})
      : registry_(registry), monitor_(std::move(monitor)) {}

  const Registry& registry() const { return registry_; }
  /// For the calls that follow.
  Monitor& monitor() { return monitor_; }

  /// Loads and plans a file, and reads its figures, claims, fit, study and scene: all that can be wrong
  /// before the first step is found here.
  LoadedModel load(const std::string& file, const LoadOptions& options = {}) const;
  /// Runs a model, or all points of its sweep on so many threads (0: all cores), and judges its claims.
  Outcome run(const LoadedModel& model, run::ExecutionMode engine = run::ExecutionMode::automatic,
              unsigned threads = 0);
  /// Runs all points of the model's sweep, whose rows are looked at run by run and not kept, and judges.
  Outcome pass(const LoadedModel& model, run::ExecutionMode engine = run::ExecutionMode::automatic,
               unsigned threads = 0);
  /// Runs the points of the model's sweep that an exchange names, on so many threads (0: all cores).
  PointsReport run(const LoadedModel& model, run::PointExchange& points,
                   run::ExecutionMode engine = run::ExecutionMode::automatic, unsigned threads = 0);
  /// Finds the parameters that the model's section `fit` names.
  estimation::FitResult fit(const LoadedModel& model, const FitCall& call = {});
  /// The model with what a fit found.
  LoadedModel fitted(const LoadedModel& model, const estimation::FitResult& result) const;
  /// Finds the parameters that the model's section `tune` names.
  tuning::TuneResult tune(const LoadedModel& model, const TuneCall& call = {});
  /// The model with what a tuning found.
  LoadedModel tuned(const LoadedModel& model, const tuning::TuneResult& result) const;
  /// Performs the model's study, or finds that it was performed; study_outcome() puts it into the model.
  Studies::Shared study(const LoadedModel& model, const StudyCall& call = {});
  /// Replays what a run left in its folder.
  replay::Verification replay(const std::string& folder) const;

 private:
  const Registry& registry_;
  Monitor monitor_;
  codegen::GeneratedCode code_{run::code_trial()};
  Studies studies_;
};

}  // namespace stepwire::session
