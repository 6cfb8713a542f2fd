#pragma once

#include <string>

#include "engine/app/session/loaded_model.hpp"

namespace stepwire::session {

/// Writes the inputs of verify_recorded() into the folder of a study of recorded trials: the flattened
/// diagram with the section `study`, and a copy of the trials. Throws EnvironmentError.
void write_recorded(const std::string& folder, const LoadedModel& model);

/// True if the folder is of a study of recorded trials.
bool has_recorded(const std::string& folder, const Registry& registry);

/// Repeats scores and analysis of the recorded trials. Returns the first difference of errors or tables,
/// "errors.csv:3: ..."; empty if all bits agree. Throws Error, TableError and EnvironmentError.
std::string verify_recorded(const std::string& folder, const Registry& registry);

}  // namespace stepwire::session
