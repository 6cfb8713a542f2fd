#pragma once

#include <functional>
#include <string>

#include "engine/app/cli/work.hpp"

namespace stepwire {

/// What a run has to tell, for people: title, claims with verdict and value, notices.
std::string outcome_text(const Work& work, const Outcome& outcome);
/// The unit of every wire: "rig.carriage.position  m".
std::string units_text(const Diagram& diagram);

/// Why runs ended early, on the standard error; of many runs the first few.
void print_faults(const RunResult& result);

/// Does something that may fail as users' things do, tells why on the standard error (one line each), and
/// returns the code that fits.
ExitCode guarded(const std::function<ExitCode()>& action);

}  // namespace stepwire
