#pragma once

#include <optional>

#include "engine/app/session/kept_experiments.hpp"
#include "engine/app/session/studies.hpp"
#include "engine/simulate/codegen/generated_code.hpp"
#include "engine/simulate/run/code_trial.hpp"

namespace stepwire::session {

/// Loader, code and trials of a model's study.
struct StudyParts {
  /// Prepares the trials of `experiments` experiments. Throws Error.
  StudyParts(const Registry& registry, const LoadedModel& model, const StudyCall& call,
             std::size_t experiments, const Monitor& monitor)
      : loader(registry, model.options.limits, model.options.reader) {
    study::TrialSource source = trial_source(
        loader, model, engine_of(model, call, study::study_count(model.job) * experiments), code, monitor);
    source.threads = call.threads;
    runs.emplace(std::move(source), *model.study, model.job, experiments);
  }

  diagram::Loader loader;
  codegen::GeneratedCode code{run::code_trial()};
  std::optional<study::TrialRuns> runs;
};

/// Performs the experiments of these seeds. Returns those of the first seed, completed by the outcomes of the
/// others; empty after an interruption. Throws Error.
study::Experiments perform_here(study::TrialRuns& runs, const LoadedModel& model,
                                const std::vector<std::uint64_t>& seeds, KeptExperiments& kept,
                                const Monitor& monitor);

/// Does the same with other processes. Throws the exceptions of ItemWorkers, and Error.
study::Experiments perform_by(messages::ItemWorkers& workers, StudyParts& parts, const LoadedModel& model,
                              const std::vector<std::uint64_t>& seeds, KeptExperiments& kept);

}  // namespace stepwire::session
