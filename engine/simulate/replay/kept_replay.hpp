#pragma once

#include <string>
#include <vector>

#include "engine/base/table/table_file.hpp"
#include "engine/simulate/replay/recorded.hpp"
#include "engine/simulate/replay/verify.hpp"
#include "engine/simulate/run/run.hpp"

namespace stepwire::replay {

/// Table of a sweep that keeps numbers of each run: a row for each, with its swept parameters.
struct KeptTable {
  Recorded recorded;
  table::Table swept{};  ///< columns of swept parameters, without rows
  table::ColumnWords words{};  ///< words of columns that hold indices of words
};

/// Reads the table. Throws Error if it does not have `runs` rows; TableError, EnvironmentError.
KeptTable read_kept_table(const std::string& file, const std::vector<std::string>& swept, std::size_t runs);

/// Runs a plan to its end and compares its numbers with those of a row. Adds the result to `verification`.
void replay_numbers(run::Executor& simulation, const run::RunNumbers& numbers, const KeptTable& table,
                    std::size_t row, const run::RunOptions& options, Verification& verification);

}  // namespace stepwire::replay
