#pragma once

#include "engine/app/session/loaded_model.hpp"
#include "engine/base/json/json.hpp"

namespace stepwire::session {

/// What results of a model follow from beside its files: the program, and the blocks from outside.
json::Json build_note(const LoadedModel& model);

/// All that decides what a search with a model finds, beside what the call sets of the search itself. Throws
/// EnvironmentError.
std::string search_key(const LoadedModel& model);

}  // namespace stepwire::session
