#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/analyse/claim/claim.hpp"
#include "engine/analyse/estimation/fit_request.hpp"
#include "engine/analyse/study/study_request.hpp"
#include "engine/model/diagram/load.hpp"
#include "engine/simulate/run/run.hpp"
#include "engine/view/plot/figure.hpp"
#include "engine/view/scene/scene.hpp"

namespace stepwire {

/// What a call asks of each file.
struct LoadOptions {
  std::vector<Setting> settings;
  PointSettings of_points{};  ///< beside them, of the points of a sweep
  std::optional<std::string> stop;
  DocumentLimits limits;
  StudyWords study{};
};

/// A diagram file with all that could be found wrong before its first step looked at.
struct LoadedModel {
  std::string file;
  LoadOptions options;  ///< by which it was loaded
  Job job;
  std::vector<Figure> figures;
  std::vector<Claim> claims;
  std::optional<FitRequest> fit;  ///< what is to be found in records before the run
  std::string hash;               ///< of the flattened diagram and its data as they were before the run
  std::shared_ptr<const Scene> scene{};  ///< null where the file shows none
  std::optional<StudyRequest> study{};   ///< whose trials are the runs of the file
  std::vector<NamedTable> tables{};      ///< that the study will make, for figures
  std::vector<std::string> blocksets{};  ///< folders of the blocks from outside that were known
};

/// Loads, plans, and reads figures and claims. Throws Error with everything that is wrong, EnvironmentError.
LoadedModel load_model(Loader& loader, const std::string& file, const LoadOptions& options);
LoadedModel load_model(const Registry& registry, const std::string& file, const LoadOptions& options);

/// A swept word as it is meant, without the quotes of its file.
std::string unquoted(const std::string& word);

}  // namespace stepwire
