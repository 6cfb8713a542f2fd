#pragma once

#include <string>
#include <vector>

#include "engine/base/table/table_file.hpp"
#include "engine/simulate/replay/recorded.hpp"
#include "engine/simulate/replay/verify.hpp"
#include "engine/simulate/run/run.hpp"

namespace stepwire::replay {

/// The one table of a sweep that keeps numbers of each run: a row for each, with what it was given.
struct KeptTable {
  Recorded recorded;
  table::Table swept{};        ///< the columns of what is swept, without rows
  table::ColumnWords words{};  ///< that the numbers of some of them stand for
};

/// Reads it. Throws Error where it does not have `runs` rows; TableError, EnvironmentError.
KeptTable read_kept_table(const std::string& file, const std::vector<std::string>& swept, std::size_t runs);

/// Runs a plan to its end and compares the numbers that are kept of it with those of a row; adds what came of it.
void replay_numbers(run::Executor& simulation, const run::RunNumbers& numbers, const KeptTable& table,
                    std::size_t row, const run::RunOptions& options, Verification& verification);

}  // namespace stepwire::replay
