#pragma once

#include <optional>
#include <string>

#include "engine/simulate/run/run.hpp"

namespace stepwire::run {

/// Refuse what would take memory that is not there, before it is taken: what a run records and what is kept of
/// the runs of a sweep, but for their rows, and the matrices of an implicit solver. Throw EnvironmentError that
/// says how much it is and how much is free.
void require_memory(const Job& job);
void require_solver_memory(const plan::Plan& plan);

/// The same for all that is recorded of all runs, together in memory.
void require_memory_of_all_rows(const Job& job);
/// "3e+08 rows with 9e+08 numbers take about 14.4 GB, and 8.2 GB are free"; nothing where they fit.
std::optional<std::string> lack_for_all_rows(const Job& job);

/// How many numbers the largest of the recordings has, of all runs that go on to their stop time.
double most_numbers(const Job& job);

}  // namespace stepwire::run
