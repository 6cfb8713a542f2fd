#pragma once

#include "engine/app/cli/run_call.hpp"

namespace stepwire::cli {

/// Refuses, before the first step, a model that has not what a call needs, or more than it has room for.
/// Throws Error, EnvironmentError.
void require_fitting(const RunCall& call, const session::LoadedModel& model);

}  // namespace stepwire::cli
