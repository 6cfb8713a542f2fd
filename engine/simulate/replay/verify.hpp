#pragma once

#include <atomic>
#include <cstddef>
#include <functional>
#include <memory>
#include <string>

#include "engine/base/table/table_file.hpp"
#include "engine/model/block/registry.hpp"
#include "engine/model/plan/plan.hpp"
#include "engine/simulate/run/run_numbers.hpp"

namespace stepwire::replay {

/// What came of replaying a folder.
struct Verification {
  std::size_t signals = 0;       ///< columns that were compared, of all tables
  std::size_t rows = 0;          ///< of all tables and runs
  std::size_t runs = 1;          ///< of a sweep
  std::size_t missing_rows = 0;  ///< that the whole runs have and the folder has not
  bool loop = false;             ///< of a real-time loop, where rows are lost rather than not reached
  bool interrupted = false;      ///< the replay itself
  std::string difference;        ///< the first in time, with its place; empty where all bits agree
};

/// Reads the numbers that the sweep of a folder keeps of its runs, of what run.json says of them, for the plan
/// of its diagram. `swept` are the columns of what is swept, `words` what the numbers of some of them stand
/// for. Throws Error.
using NumbersReader = std::function<std::shared_ptr<const run::RunNumbers>(
    const plan::Plan& plan, const yaml::Node& note, const table::Table& swept, const table::ColumnWords& words)>;

/// Replays what `run` or `loop` left in a folder, and compares all signals that were recorded bit by bit, or
/// the numbers that were made of them. Once `interrupt` is true it gives up. Throws Error or TableError where
/// the folder is not such a one or damaged, and Error for numbers without a reader; EnvironmentError.
Verification verify(const std::string& folder, const Registry& registry,
                    const std::atomic<bool>* interrupt = nullptr, const NumbersReader& numbers = {});

/// "3 signals in 3001 rows: all bits agree", or the difference, with its place first.
std::string verification_text(const Verification& verification);

}  // namespace stepwire::replay
