#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "engine/analyse/claim/claim.hpp"
#include "engine/analyse/estimation/fit_request.hpp"
#include "engine/analyse/study/study_request.hpp"
#include "engine/app/cli/exit_code.hpp"
#include "engine/model/diagram/load.hpp"
#include "engine/simulate/run/run.hpp"
#include "engine/view/plot/figure.hpp"
#include "engine/view/scene/scene.hpp"

namespace stepwire {

/// A diagram file with all that could be found wrong before its first step looked at.
struct Work {
  std::string file;
  Job job;
  std::vector<Figure> figures;
  std::vector<Claim> claims;
  std::optional<FitRequest> fit;  ///< what is to be found in records before the run
  std::string hash;               ///< of the flattened diagram and its data as they were before the run
  std::shared_ptr<const Scene> scene{};  ///< null where the file shows none
  std::optional<StudyRequest> study{};   ///< whose trials are the runs of the file
  std::vector<NamedTable> tables{};      ///< that the study will make, for figures
};

/// What a call asks of each file.
struct WorkOptions {
  std::vector<Setting> settings;
  PointSettings of_points{};  ///< beside them, of the points of a sweep
  std::optional<std::string> stop;
  DocumentLimits limits;
  StudyWords study{};
};

/// Loads, plans, and reads figures and claims. Throws Error with everything that is wrong, SurroundingsError.
Work prepare(Loader& loader, const std::string& file, const WorkOptions& options);
Work prepare(const Registry& registry, const std::string& file, const WorkOptions& options);

/// What became of a file.
struct Outcome {
  RunResult result;
  std::vector<Recording> shown;  ///< the recordings with what the scene shows; empty where there is none
  std::vector<Verdict> verdicts;
  double seconds = 0.0;  ///< of the run itself, without loading and drawing
  ExitCode code = ExitCode::done;

  /// What figures and claims read.
  std::span<const Recording> recordings() const { return shown.empty() ? result.recordings : shown; }
};

/// Judges all claims on what was recorded; those about a run that ended early do not hold.
void judge_claims(const Work& work, Outcome& outcome);

/// Runs and judges. Claims about a run that ended early are not judged and do not hold.
Outcome carry_out(const Work& work, const RunOptions& options);

/// A swept word as it is meant, without the quotes of its file.
std::string unquoted(const std::string& word);

}  // namespace stepwire
