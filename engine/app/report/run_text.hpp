#pragma once

#include <string>

#include "engine/app/session/outcome.hpp"

namespace stepwire::report {

/// What a run has to tell, for people: title, claims with verdict and value, diagnostics.
std::string outcome_text(const session::LoadedModel& model, const session::Outcome& outcome);
/// The file and its claims that failed; empty where none has.
std::string failures_text(const session::Outcome& outcome, const std::string& file);
/// The unit of every wire, and its shape: "rig.carriage.position  m", "body.attitude  1 (3 x 3)".
std::string units_text(const plan::Plan& plan);

}  // namespace stepwire::report
