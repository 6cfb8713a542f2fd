#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/analyse/claim/claim.hpp"
#include "engine/analyse/estimation/fit_request.hpp"
#include "engine/analyse/kept/names.hpp"
#include "engine/analyse/linear/section.hpp"
#include "engine/analyse/linear/trim.hpp"
#include "engine/analyse/sensitivity/sensitivity.hpp"
#include "engine/analyse/study/study_request.hpp"
#include "engine/analyse/tuning/tune_request.hpp"
#include "engine/model/diagram/load.hpp"
#include "engine/simulate/run/run.hpp"
#include "engine/view/plot/figure.hpp"
#include "engine/view/scene/scene.hpp"

namespace stepwire::session {

/// What a call asks of each file.
struct LoadOptions {
  std::vector<diagram::Setting> settings;
  run::PointSettings of_points{};  ///< beside them, of the points of a sweep
  std::optional<std::string> stop;
  unsigned threads = 0;  ///< that look at the points of a sweep; 0: all cores
  yaml::DocumentLimits limits;
  study::StudyWords study{};
  std::optional<yaml::Node> figure{};  ///< in the place of the file's section
  diagram::DocumentReader reader{};    ///< where the texts of files are; without it files are read
};

/// A diagram file with all that could be found wrong before its first step looked at.
struct LoadedModel {
  std::string file;
  LoadOptions options;  ///< by which it was loaded
  run::Job job;
  std::vector<plot::Figure> figures;
  std::vector<claim::Claim> claims;
  std::optional<estimation::FitRequest> fit;  ///< what is to be found in records before the run
  std::string hash;  ///< of the flattened diagram and its data as they were before the run
  std::shared_ptr<const scene::Scene> scene{};    ///< null where the file shows none
  std::optional<study::StudyRequest> study{};     ///< whose trials are the runs of the file
  std::vector<query::NamedTable> tables{};        ///< that the study will make, for figures
  std::shared_ptr<const run::RunNumbers> kept{};  ///< what the sweep keeps of each run; null: its rows
  std::optional<sensitivity::Request> sensitivity{};
  std::vector<linear::NamedAnalysis> linear{};  ///< that figures and claims read behind the recordings
  std::optional<linear::TrimRequest> trim{};    ///< the operating point that is looked for
  std::optional<tuning::TuneRequest> tune{};    ///< what `tune` minimises; no run hangs on it
  const Registry* registry = nullptr;           ///< by which it was loaded
  std::vector<std::string> blocksets{};         ///< folders of the blocks from outside that were known
};

/// The name of the table of a sensitivity.
inline constexpr const char* sensitivity_table = "sensitivity";

/// Loads, plans, and reads figures and claims. Throws Error with everything that is wrong, EnvironmentError.
LoadedModel load_model(diagram::Loader& loader, const std::string& file, const LoadOptions& options);
LoadedModel load_model(const Registry& registry, const std::string& file, const LoadOptions& options);

using kept::without_quotes;

}  // namespace stepwire::session
