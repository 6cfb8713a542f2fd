#pragma once

#include <string>

#include "engine/app/session/tuning.hpp"

namespace stepwire::report {

/// What a tuning found, for people.
std::string tune_text(const tuning::TuneResult& result);

}  // namespace stepwire::report
