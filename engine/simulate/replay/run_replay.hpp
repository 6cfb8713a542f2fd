#pragma once

#include <string>
#include <vector>

#include "engine/base/table/table_file.hpp"
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

/// Number of columns of a loop's table before its signals: time, tick, wall.
inline constexpr std::size_t first_signal_of_loop = 3;

/// Steps a plan tick by tick with the recorded inputs, and compares the rows by their ticks. Adds the result
/// to `verification`. With an `end_of_loop` there, rows after the last one of the inputs are not compared.
/// Throws Error if ticks or inputs are not as a loop writes them.
void replay_loop(const plan::Plan& plan, const std::vector<Recorded>& tables, const std::string& inputs_file,
                 const run::RunOptions& options, Verification& verification);

/// Table of a sweep that keeps numbers of each run: a row for each, with its swept parameters.
struct KeptTable {
  Recorded recorded;
  table::Table swept{};        ///< columns of swept parameters, without rows
  table::ColumnWords words{};  ///< words of columns that hold indices of words
};

/// Reads the table. Throws Error if it does not have `runs` rows; TableError, EnvironmentError.
KeptTable read_kept_table(const std::string& file, const std::vector<std::string>& swept, std::size_t runs);

/// Runs a plan to its end and compares its numbers with those of a row. Adds the result to `verification`.
void replay_numbers(run::Executor& simulation, const run::RunNumbers& numbers, const KeptTable& table,
                    std::size_t row, const run::RunOptions& options, Verification& verification);

}  // namespace stepwire::replay
