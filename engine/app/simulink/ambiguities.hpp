#pragma once

#include <string>
#include <vector>

#include "engine/app/simulink/import_result.hpp"
#include "engine/app/simulink/model.hpp"

namespace stepwire::simulink {

/// Returns a sentence on each place of a system that has two meanings: blocks with one SID, ports with one
/// number, inputs with two lines. `path` is that of the system, "Plant/".
std::vector<Note> ambiguities_of(const Model& model, const System& system, const std::string& path);

}  // namespace stepwire::simulink
