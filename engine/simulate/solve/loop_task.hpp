#pragma once

#include <cstddef>
#include <cstdint>

namespace stepwire::solve {

/// A signal at which a loop is torn: where its numbers lie in the workspace.
struct Tear {
  std::size_t offset, size;
};

/// What is known of a loop in a run: numbers of the workspace, in this order.
struct LoopReport {
  static constexpr std::size_t instants = 0;  ///< at which it was solved, or tried
  static constexpr std::size_t passes = 1;    ///< through its blocks, all together
  static constexpr std::size_t most = 2;      ///< passes at one instant
  static constexpr std::size_t unsolved = 3;  ///< instants
  static constexpr std::size_t time = 4;      ///< of the first that is not solved [s]
  static constexpr std::size_t residual = 5;  ///< there: the largest difference of a number and its guess
  static constexpr std::size_t number = 6;    ///< which of the torn numbers has it
  static constexpr std::size_t count = 7;
};

/// A loop as its solver sees it.
struct LoopTask {
  const Tear* tears;
  std::size_t tear_count;
  const std::size_t* diagnostics;  ///< of its blocks, where they lie: what a guess raises is taken back
  std::size_t diagnostic_count;
  std::size_t report;  ///< where a LoopReport lies, and behind it as many numbers as there are diagnostics
  std::size_t time;    ///< where the time lies
  double tolerance;    ///< largest correction that is none, in sizes of its signal
  std::int64_t max_passes;  ///< at one instant
};

}  // namespace stepwire::solve
