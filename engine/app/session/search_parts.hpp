#pragma once

#include <vector>

#include "engine/app/session/loaded_model.hpp"
#include "engine/simulate/codegen/generated_code.hpp"
#include "engine/simulate/run/code_trial.hpp"

namespace stepwire::session {

/// What a call sets, its stop time among it.
std::vector<diagram::Setting> call_settings(const LoadOptions& options);

/// What the runs of a search for values of a model's parameters are made of, such as a fit or a tuning.
struct SearchParts {
  /// `runs` counts runs, each of all points of a sweep. With the automatic mode code is compiled for them if
  /// they would take longer than a compilation.
  SearchParts(const Registry& registry, const LoadedModel& model, run::ExecutionMode engine, double runs);

  codegen::GeneratedCode code{run::code_trial()};
  plan::CodeSource* used;  ///< the code; null: runs are interpreted
  diagram::Loader loader;
  std::vector<diagram::Setting> settings;
};

}  // namespace stepwire::session
