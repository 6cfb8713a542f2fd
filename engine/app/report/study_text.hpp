#pragma once

#include <string>

#include "engine/app/session/studies.hpp"

namespace stepwire {

/// What the study found, for people.
std::string study_text(const LoadedModel& model, const Experiments& experiments);

}  // namespace stepwire
