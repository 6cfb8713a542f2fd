#pragma once

#include <optional>
#include <string>

#include "engine/simulate/run/run.hpp"

namespace stepwire::run {

/// Checks before a job begins that its memory is available.
///
/// Covered are the recording of a run, the single rows that a sweep keeps of its runs, and the matrices of an
/// implicit solver. Throw EnvironmentError with the needed and the free memory.
void require_memory(const Job& job);
void require_solver_memory(const plan::Plan& plan);

/// Checks the memory for the recordings of all runs together. Throws as require_memory() does.
void require_memory_of_all_rows(const Job& job);
/// Returns "3e+08 rows with 9e+08 numbers take about 14.4 GB, and 8.2 GB are free". Returns std::nullopt if
/// they fit.
std::optional<std::string> lack_for_all_rows(const Job& job);

/// Returns the count of numbers in the largest recording, of all runs that reach their stop time.
double most_numbers(const Job& job);

}  // namespace stepwire::run
