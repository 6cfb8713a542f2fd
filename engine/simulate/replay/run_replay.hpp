#pragma once

#include "engine/simulate/replay/recorded.hpp"
#include "engine/simulate/replay/verify.hpp"
#include "engine/simulate/run/run.hpp"

namespace stepwire::replay {

/// Runs a plan as far as its rows go, with the observers of `options`, and compares them, one entry of `rows`
/// for each recording; adds what came of it. Returns how many of each entry's rows were this run's.
std::vector<std::size_t> replay_run(run::Executor& simulation, const std::vector<RecordedRows>& rows,
                                    const run::RunOptions& options, Verification& verification);

/// Runs a plan to its end and compares the last row of each table's request with the row of this number, of
/// which a run that a fault ended has left none; adds what came of it.
void replay_last_row(run::Executor& simulation, const std::vector<Recorded>& tables, std::size_t row,
                     const run::RunOptions& options, Verification& verification);

}  // namespace stepwire::replay
