#pragma once

#include <cstddef>
#include <cstdint>

namespace stepwire::solve {

/// Signal at which a loop is torn, with the places in the workspace of its numbers and of the residuals that
/// the last solution has left in them.
struct Tear {
  std::size_t offset, size, residual;
};

/// Statistics of a loop in a run, as indices into numbers of the workspace.
struct LoopReport {
  static constexpr std::size_t instants = 0;  ///< Instants at which it was solved or tried.
  static constexpr std::size_t passes = 1;    ///< Total passes through its blocks.
  static constexpr std::size_t most = 2;      ///< Largest number of passes at one instant.
  static constexpr std::size_t unsolved = 3;  ///< Instants without a solution.
  static constexpr std::size_t time = 4;      ///< Time of the first of them [s].
  static constexpr std::size_t residual = 5;  ///< Largest residual there.
  static constexpr std::size_t number = 6;    ///< Index of the torn number that has it.
  static constexpr std::size_t count = 7;
};

/// Loop in the form that its solver needs.
struct LoopTask {
  const Tear* tears;
  std::size_t tear_count;
  const std::size_t* diagnostics;  ///< Places of its blocks' diagnostics.
  std::size_t diagnostic_count;
  std::size_t report;       ///< Place of a LoopReport, followed by a number for each diagnostic.
  std::size_t time;         ///< Place of the time.
  double tolerance;         ///< Largest negligible correction, relative to the size of its signal.
  std::int64_t max_passes;  ///< Limit at one instant.
};

}  // namespace stepwire::solve
