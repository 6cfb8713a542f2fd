#pragma once

#include <string>

#include "engine/app/session/tuning.hpp"

namespace stepwire::report {

/// Returns the result of an optimisation as text for the terminal.
std::string tune_text(const tuning::TuneResult& result);

}  // namespace stepwire::report
