#pragma once

#include <functional>
#include <vector>

#include "engine/app/session/loaded_model.hpp"
#include "engine/app/studio/live/run_thread.hpp"

namespace stepwire::live {

/// What the records of a plan have of its run by now, from a tick on; `ended`: with the row of the last tick.
std::vector<record::Recording> recorded_rows(const plan::Plan& plan, const SignalList& signals,
                                             RunControl& run, bool ended, std::int64_t from = 0);

/// What the file's entries of `record` have by now, the same bits as `run` writes at its end, with the
/// present values of what the file sweeps; rows from the tick `from` on. `ended`: the last tick makes a row,
/// too, where the period skips it.
std::vector<record::Recording> recorded_so_far(const session::LoadedModel& model, const SignalList& signals,
                                               RunControl& run, bool ended, std::int64_t from = 0);

}  // namespace stepwire::live
