#pragma once

#include <string>

#include "engine/app/session/outcome.hpp"

namespace stepwire::report {

/// Returns the outcome of a run as text: title, claims with verdict and value, diagnostics.
std::string outcome_text(const session::LoadedModel& model, const session::Outcome& outcome);
/// Returns the file and its failed claims; empty if all hold.
std::string failures_text(const session::Outcome& outcome, const std::string& file);
/// Returns unit and shape of every wire: "rig.carriage.position  m", "body.attitude  1 (3 x 3)".
std::string units_text(const plan::Plan& plan);

}  // namespace stepwire::report
