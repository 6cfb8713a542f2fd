#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>

#include "engine/base/table/table_file.hpp"
#include "engine/model/block/registry.hpp"
#include "engine/model/plan/plan.hpp"
#include "engine/simulate/run/run_numbers.hpp"

namespace stepwire::replay {

/// Result of replaying a folder.
struct Verification {
  std::size_t signals = 0;         ///< Compared columns of all tables.
  std::size_t rows = 0;            ///< Rows of all tables and runs.
  std::size_t runs = 1;            ///< Runs of a sweep.
  std::size_t missing_rows = 0;    ///< Rows of complete runs that are missing in the folder.
  std::int64_t ticks = 0;          ///< Ticks after which the runs may have ended, by their rows.
  std::string first_missing;       ///< Place and time of the first missing row; empty without one.
  bool loop = false;               ///< True for a real-time loop, whose missing rows are lost ones.
  std::string end_of_loop;         ///< Clause on rows after the last one; empty without loss.
  std::size_t without_inputs = 0;  ///< Rows of a loop that are not compared, since inputs.csv ends before.
  bool interrupted = false;        ///< True if the replay was interrupted.
  std::string difference;          ///< First difference in time, with its place; empty without one.
};

/// Reads the numbers that a sweep keeps of its runs from their entry of run.json, for the plan of its
/// diagram. Argument `swept` has the columns of swept parameters. Argument `words` has the words of those
/// that hold indices of words. Throws Error.
using NumbersReader = std::function<std::shared_ptr<const run::RunNumbers>(
    const plan::Plan& plan, const yaml::Node& note, const table::Table& swept,
    const table::ColumnWords& words)>;

/// Replays the folder of `run` or `loop`. Compares all recorded signals, or the numbers computed from them,
/// bit by bit. Ends early once `interrupt` is true. Throws Error or TableError for any other or damaged
/// folder, and Error for numbers without a reader; EnvironmentError.
Verification verify(const std::string& folder, const Registry& registry,
                    const std::atomic<bool>* interrupt = nullptr, const NumbersReader& numbers = {});

/// Returns "3 signals in 3001 rows: all bits agree", or the difference, with its place first.
std::string verification_text(const Verification& verification);

}  // namespace stepwire::replay
