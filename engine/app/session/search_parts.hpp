#pragma once

#include <string>
#include <vector>

#include "engine/app/session/loaded_model.hpp"
#include "engine/simulate/codegen/generated_code.hpp"
#include "engine/simulate/run/code_trial.hpp"

namespace stepwire::session {

/// Returns the settings of the call, with the stop time as one of them.
std::vector<diagram::Setting> call_settings(const LoadOptions& options);

/// Returns settings as text of a file for --set-from. `origin` begins its comment: "Found by a trim of".
std::string parameters_text(const std::string& origin, const std::string& file,
                            const std::vector<diagram::Setting>& settings);

/// Loader, code and settings for the runs of a search over parameter values, in a fit or an optimisation.
struct SearchParts {
  /// `runs` is an estimate of the runs, each over all points of a sweep. In automatic mode code is compiled
  /// if interpreting them would take longer than a compilation.
  SearchParts(const Registry& registry, const LoadedModel& model, run::ExecutionMode engine, double runs);

  codegen::GeneratedCode code{run::code_trial()};
  plan::CodeSource* used;  ///< &code; nullptr: runs are interpreted
  diagram::Loader loader;
  std::vector<diagram::Setting> settings;
};

}  // namespace stepwire::session
