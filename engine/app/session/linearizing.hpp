#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/analyse/linear/analysis.hpp"
#include "engine/analyse/linear/trim.hpp"
#include "engine/app/session/loaded_model.hpp"

namespace stepwire::session {

/// Options of a linear analysis.
struct LinearCall {
  std::vector<std::string> from, to;  ///< empty: all inputs, all outputs of the diagram
  std::vector<std::string> open;
  double time = 0.0;               ///< time of the operating point [s]
  std::optional<double> size;      ///< step of the finite differences
  std::optional<double> feedback;  ///< sign of the feedback, +1 or -1
};

/// Linearizes a file with the given options, without reading its figures and claims. Throws Error.
linear::Analysis linearize_file(const Registry& registry, const std::string& file, const LoadOptions& options,
                                const LinearCall& call);

/// Finds the operating point of the section `trim`. Throws Error, also if the file has no such section.
linear::TrimResult trim_file(const Registry& registry, const std::string& file, const LoadOptions& options);
/// Returns the operating point as settings of --set.
std::vector<diagram::Setting> settings_of(const linear::TrimResult& result);
/// Writes trim.json and parameters.yaml, a file for --set-from. Throws EnvironmentError.
void write_trim(const std::string& folder, const linear::TrimResult& result);

/// Performs the analyses of the section `linear` and returns one recording each for figures and claims, with
/// all points of a sweep. What could not be determined is added to `diagnostics`. Throws Error.
std::vector<record::Recording> linear_recordings(const LoadedModel& model,
                                                 std::vector<run::RaisedDiagnostic>& diagnostics);

/// Writes linear.json and linear.mat into a folder. Throws EnvironmentError.
void write_linear(const std::string& folder, const linear::Analysis& analysis);

}  // namespace stepwire::session
