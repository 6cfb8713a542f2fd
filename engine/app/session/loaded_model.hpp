#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/analyse/claim/claim.hpp"
#include "engine/analyse/estimation/fit_request.hpp"
#include "engine/analyse/kept/names.hpp"
#include "engine/analyse/linear/request.hpp"
#include "engine/analyse/linear/trim.hpp"
#include "engine/analyse/sensitivity/sensitivity.hpp"
#include "engine/analyse/study/study_request.hpp"
#include "engine/analyse/tuning/tune_request.hpp"
#include "engine/model/diagram/load.hpp"
#include "engine/simulate/run/run.hpp"
#include "engine/view/plot/figure.hpp"
#include "engine/view/scene/scene.hpp"

namespace stepwire::session {

/// Options for loading a diagram file.
struct LoadOptions {
  std::vector<diagram::Setting> settings;
  run::PointSettings of_points{};  ///< additional settings of each point of a sweep
  std::optional<std::string> stop;
  unsigned threads = 0;  ///< threads that load the points of a sweep; 0: all cores
  yaml::DocumentLimits limits;
  study::StudyWords study{};
  std::optional<yaml::Node> figure{};  ///< replaces the section `figure`
  diagram::DocumentReader reader{};    ///< source of file contents; empty: the file system
};

/// Diagram file with all checks that are possible before its first step.
struct LoadedModel {
  std::string file;
  LoadOptions options;  ///< the options of the load
  run::Job job;
  std::vector<plot::Figure> figures;
  std::vector<claim::Claim> claims;
  std::optional<estimation::FitRequest> fit;  ///< Parameters to estimate from records before the run.
  std::string hash;                           ///< Hash of the flattened diagram and its data before the run.
  std::shared_ptr<const scene::Scene> scene{};    ///< nullptr without a section `scene`.
  std::optional<study::StudyRequest> study{};     ///< Study whose trials are the runs of the file.
  std::vector<query::NamedTable> tables{};        ///< Tables of the study or the sensitivity, filled later.
  std::shared_ptr<const run::RunNumbers> kept{};  ///< Numbers kept of each run; nullptr: rows are kept.
  std::optional<sensitivity::Request> sensitivity{};
  std::vector<linear::NamedAnalysis> linear{};  ///< Analyses whose recordings follow those of the runs.
  std::optional<linear::TrimRequest> trim{};    ///< Request for an operating point.
  std::optional<tuning::TuneRequest> tune{};    ///< Request for an optimisation; it does not affect runs.
  const Registry* registry = nullptr;           ///< Registry of the load.
  std::vector<std::string> blocksets{};         ///< Folders of the external blocks at the load.
};

/// Name of the table of a sensitivity analysis.
inline constexpr const char* sensitivity_table = "sensitivity";

/// Loads and plans a file, and reads its figures and claims. Throws Error with all faults, and
/// EnvironmentError.
LoadedModel load_model(diagram::Loader& loader, const std::string& file, const LoadOptions& options);
LoadedModel load_model(const Registry& registry, const std::string& file, const LoadOptions& options);

using kept::without_quotes;

}  // namespace stepwire::session
