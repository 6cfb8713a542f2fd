#pragma once

#include <string>

#include "engine/app/session/studies.hpp"

namespace stepwire::report {

/// Returns the results of a study as text for the terminal.
std::string study_text(const session::LoadedModel& model, const study::Experiments& experiments);

}  // namespace stepwire::report
