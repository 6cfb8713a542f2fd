#pragma once

#include "engine/app/cli/run_call.hpp"

namespace stepwire::cli {

/// Refuses a model that does not fit the options of a call, before the first step. Throws Error and
/// EnvironmentError.
void require_fitting(const RunCall& call, const session::LoadedModel& model);

}  // namespace stepwire::cli
