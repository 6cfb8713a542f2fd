#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/analyse/linear/analysis.hpp"
#include "engine/analyse/linear/trim.hpp"
#include "engine/app/session/loaded_model.hpp"
#include "engine/base/json/json.hpp"

namespace stepwire::session {

/// What a call asks of a linear analysis.
struct LinearCall {
  std::vector<std::string> from, to;  ///< empty: all inputs, all outputs of the diagram
  std::vector<std::string> open;
  double time = 0.0;               ///< [s]
  std::optional<double> size;      ///< of differences
  std::optional<double> feedback;  ///< +1 or -1
};

/// Linearizes a file with the values of the options, without reading its figures and claims. Throws Error.
linear::Analysis linearize_file(const Registry& registry, const std::string& file, const LoadOptions& options,
                                const LinearCall& call);

/// Looks for the operating point of the file's section `trim`. Throws Error, also where it has none.
linear::TrimResult trim_file(const Registry& registry, const std::string& file, const LoadOptions& options);
/// What was found, as --set sets it.
std::vector<diagram::Setting> settings_of(const linear::TrimResult& result);
json::Json trim_json(const std::string& file, const linear::TrimResult& result);
/// Writes trim.json and parameters.yaml, which --set-from takes. Throws EnvironmentError.
void write_trim(const std::string& folder, const std::string& file, const linear::TrimResult& result);

/// What figures and claims read of the section `linear`: a recording for each of its analyses, with all
/// points of a sweep. Throws Error.
std::vector<record::Recording> linear_recordings(const LoadedModel& model);

/// All that was found, for programs: matrices as lists of rows, complex numbers as [re, im], what is infinite
/// as null.
json::Json linear_json(const std::string& file, const linear::Analysis& analysis);

/// Writes linear.json and linear.mat into a folder. Throws EnvironmentError.
void write_linear(const std::string& folder, const std::string& file, const linear::Analysis& analysis);

}  // namespace stepwire::session
