#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "engine/base/table/table.hpp"
#include "engine/model/plan/plan.hpp"
#include "engine/simulate/realtime/row_ring.hpp"

namespace stepwire::realtime {

/// A file that a loop leaves behind, and its columns (without values). The columns `time` and `tick` come
/// first.
struct LoopFile {
  std::string name;  ///< "signals.csv"
  std::vector<table::Column> columns;
};

/// One file for each `record` of the diagram, with time, tick, wall (when the thread woke, since the start)
/// and the signals as a run names them; and inputs.csv, with time, tick and what the tick was given, where
/// the diagram has inputs. Throws Error where a signal or input has the name of one of those columns.
std::vector<LoopFile> loop_files(const plan::Plan& plan);

/// Puts rows into the ring, from the loop thread. In the ring a row is the index of its file and the numbers
/// of its columns.
class LoopRecorder {
 public:
  LoopRecorder(const plan::Plan& plan, RowRing& ring);

  /// The signals of a tick, for the files whose period it is in. `wall` in s.
  void record_signals(std::int64_t tick, double wall, const double* values);
  /// What a tick was given: all elements of all inputs.
  void record_inputs(std::int64_t tick, const double* inputs);

  /// Rows that were put into the ring, and rows for which it had no room.
  std::int64_t rows() const { return rows_; }
  std::int64_t lost() const { return lost_; }

  /// The most numbers that rows of one tick take in the ring.
  static std::size_t numbers_per_tick(const plan::Plan& plan);

 private:
  struct Signals {
    std::int64_t every = 1, next_tick = 0;
    std::vector<std::size_t> offsets;  ///< in the workspace
    std::vector<double> row;
  };
  void push(const std::vector<double>& row);

  RowRing& ring_;
  double step_;
  std::vector<Signals> signals_;
  std::vector<double> inputs_row_;
  std::int64_t rows_ = 0, lost_ = 0;
};

}  // namespace stepwire::realtime
