#pragma once

#include "engine/simulate/replay/recorded.hpp"
#include "engine/simulate/replay/verify.hpp"
#include "engine/simulate/run/run.hpp"

namespace stepwire::replay {

/// Runs a plan as far as its rows reach, with the observers of `options`, and compares the rows, one entry of
/// `rows` for each recording. Adds the result to `verification`. Returns how many rows of each entry were of
/// this run.
std::vector<std::size_t> replay_run(run::Executor& simulation, const std::vector<RecordedRows>& rows,
                                    const run::RunOptions& options, Verification& verification);

/// Runs a plan to its end and compares the last row of each request with a row of each table. A run that
/// ended with a fault has no row. Adds the result to `verification`.
void replay_last_row(run::Executor& simulation, const std::vector<Recorded>& tables, std::size_t row,
                     const run::RunOptions& options, Verification& verification);

}  // namespace stepwire::replay
