#pragma once

#include <string>

#include "engine/app/session/loaded_model.hpp"

namespace stepwire::session {

/// Writes into the folder of a study of recorded trials what verify_recorded() needs: the flattened diagram
/// with the study as its section, and a copy of the trials. Throws EnvironmentError.
void write_recorded(const std::string& folder, const LoadedModel& model);

/// Is it such a folder?
bool has_recorded(const std::string& folder, const Registry& registry);

/// Scores and analyses the trials of such a folder again. "errors.csv:3: ..." where its errors or its tables
/// have come out otherwise; empty where all bits agree. Throws Error, TableError, EnvironmentError.
std::string verify_recorded(const std::string& folder, const Registry& registry);

}  // namespace stepwire::session
