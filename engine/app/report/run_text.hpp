#pragma once

#include <string>

#include "engine/app/session/outcome.hpp"

namespace stepwire::report {

/// What a run has to tell, for people: title, claims with verdict and value, diagnostics.
std::string outcome_text(const session::LoadedModel& model, const session::Outcome& outcome);
/// The unit of every wire: "rig.carriage.position  m".
std::string units_text(const diagram::Diagram& diagram);

}  // namespace stepwire::report
