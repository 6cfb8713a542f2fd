#pragma once

// Included by the text of kernels, too.

#include <cstdint>

namespace stepwire::device {

/// Runs of one plan in the memory of a device, and a piece of their ticks. It is the argument of a kernel.
///
/// Each run ends by itself, at the tick at which it would end alone, and its numbers then stay as they are.
/// Rows of the piece are written one record request after the other. Number c of row k of run r is at
/// (k * columns + c) * count + r of its request, and a request has room for rows_of() rows.
struct Piece {
  double* values;         ///< Workspaces: number n of run r is at n * count + r.
  const double* numbers;  ///< Tables of numbers: that of run r begins at r * table.
  std::int32_t* ends;     ///< 0 for an active run, else 1 + plan::LaneTask::How.
  std::int64_t* ticks;    ///< Tick at which a run has ended.
  double* rows;           ///< nullptr where no rows are kept.
  std::int64_t tick;      ///< First tick of the piece.
  std::int64_t end;       ///< Tick before which the kernel returns; its outputs are not computed.
  std::int64_t stop;      ///< Tick at which all runs end.
  std::int64_t count;     ///< Number of runs.
  std::int64_t table;     ///< Size of a table.

  /// Returns the room for rows of a request with a row every `every` ticks.
  std::int64_t rows_of(std::int64_t every) const { return (end - tick) / every + 1; }
};

}  // namespace stepwire::device
