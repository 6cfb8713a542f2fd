#pragma once

#include <string>

#include "engine/app/session/loaded_model.hpp"
#include "engine/base/json/json.hpp"

namespace stepwire::session {

/// Returns the version of the program and of the external blocks, on which results depend in addition to the
/// files.
json::Json build_note(const LoadedModel& model);

/// Returns a key of everything that determines the result of a search with a model, except the search options
/// of the call. Throws EnvironmentError.
std::string search_key(const LoadedModel& model);

/// Returns the version of the program, which CMakeLists.txt has: "major.minor.patch".
std::string program_version();
/// Returns compiler and flags of the program: "g++ 12.2.0 -O2 ...".
std::string compiler_version();

}  // namespace stepwire::session
