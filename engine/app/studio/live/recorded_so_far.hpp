#pragma once

#include <functional>
#include <vector>

#include "engine/app/session/loaded_model.hpp"
#include "engine/app/studio/live/run_thread.hpp"

namespace stepwire::live {

/// Returns the records of a plan so far, from a tick on. `ended`: includes the row of the last tick.
std::vector<record::Recording> recorded_rows(const plan::Plan& plan, const SignalList& signals,
                                             RunControl& run, bool ended, std::int64_t from = 0);

/// Returns the records of the file so far, from the tick `from` on, with the present values of swept
/// parameters. The bits equal those that `run` writes at its end. `ended`: the last tick has a row even if
/// the period skips it.
std::vector<record::Recording> recorded_so_far(const session::LoadedModel& model, const SignalList& signals,
                                               RunControl& run, bool ended, std::int64_t from = 0);

}  // namespace stepwire::live
