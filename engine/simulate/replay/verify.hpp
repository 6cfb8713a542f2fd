#pragma once

#include <atomic>
#include <cstddef>
#include <string>

#include "engine/model/block/registry.hpp"

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

/// Replays what `run` or `loop` left in a folder, and compares all signals that were recorded bit by bit.
/// Once `interrupt` is true it gives up. Throws Error or TableError where the folder is not such a one or
/// damaged, EnvironmentError.
Verification verify(const std::string& folder, const Registry& registry,
                    const std::atomic<bool>* interrupt = nullptr);

/// "3 signals in 3001 rows: all bits agree", or the difference, with its place first.
std::string verification_text(const Verification& verification);

}  // namespace stepwire::replay
