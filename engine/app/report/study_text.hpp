#pragma once

#include <string>

#include "engine/app/session/studies.hpp"

namespace stepwire::report {

/// What the study found, for people.
std::string study_text(const session::LoadedModel& model, const study::Experiments& experiments);

}  // namespace stepwire::report
