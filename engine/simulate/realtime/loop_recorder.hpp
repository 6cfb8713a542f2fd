#pragma once

#include <condition_variable>
#include <cstdint>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "engine/base/table/table.hpp"
#include "engine/model/plan/plan.hpp"
#include "engine/simulate/realtime/row_ring.hpp"

namespace stepwire::realtime {

/// File that a loop writes, and its columns (without values). The columns `time` and `tick` are the first
/// ones.
struct LoopFile {
  std::string name;  ///< "signals.csv"
  std::vector<table::Column> columns;
};

/// Returns the files of a loop. Each `record` of the diagram has one, with time, tick, wall (wake-up time
/// since the start) and the signals as in a run. A diagram with inputs also has inputs.csv, with time, tick
/// and the inputs of the tick. Throws Error if a signal or input has the name of one of those columns.
std::vector<LoopFile> loop_files(const plan::Plan& plan);

/// Writes rows into the ring, from the loop thread. A row in the ring is the index of its file and the
/// numbers of its columns.
class LoopRecorder {
 public:
  LoopRecorder(const plan::Plan& plan, RowRing& ring);

  /// Writes the signals of a tick into the files whose period is due. `wall` is in s.
  void record_signals(std::int64_t tick, double wall, const double* values);
  /// Writes the inputs of a tick, with all elements.
  void record_inputs(std::int64_t tick, const double* inputs);

  /// Return the count of rows in the ring, and of rows for which it had no space.
  std::int64_t rows() const { return rows_; }
  std::int64_t lost() const { return lost_; }

  /// Returns the largest count of numbers in the rows of one tick.
  static std::size_t numbers_per_tick(const plan::Plan& plan);

 private:
  struct Signals {
    std::int64_t every = 1, next_tick = 0;
    std::vector<std::size_t> offsets;  ///< in the workspace
    std::vector<double> row;
  };
  void push(const std::vector<double>& row);

  RowRing& ring_;
  TickTimes time_of_;
  std::vector<Signals> signals_;
  std::vector<double> inputs_row_;
  std::int64_t rows_ = 0, lost_ = 0;
};

/// Writes the rows of a ring into the files of a loop, in a thread of its own. A file gets its name with its
/// first rows, which a kill of the loop so leaves, or in finish(); without both it is removed.
class RowWriter {
 public:
  /// Throws EnvironmentError if a file cannot be created.
  RowWriter(RowRing& ring, const std::string& folder, const std::vector<LoopFile>& files);
  ~RowWriter();
  RowWriter(const RowWriter&) = delete;
  RowWriter& operator=(const RowWriter&) = delete;

  /// Writes the remaining rows of the ring, whose writer must have ended, and renames the files. Throws
  /// EnvironmentError on failure.
  void finish();

  /// After finish(), return the count of rows in the files, and of rows that could not be written.
  std::int64_t rows() const { return rows_; }
  std::int64_t lost() const { return lost_; }
  /// Returns the system error of the first row that could not be written; an empty text if all were.
  std::string trouble() const;

 private:
  class Sink;

  void work();
  void stop();
  bool take();

  RowRing& ring_;
  std::vector<std::unique_ptr<Sink>> sinks_;
  std::vector<double> numbers_;  ///< read from the ring; an incomplete row is at the front
  std::size_t filled_ = 0;
  std::int64_t rows_ = 0, lost_ = 0;
  std::mutex mutex_;  ///< for finish() and the writing thread; never locked by the loop thread
  std::condition_variable ended_;
  bool ending_ = false;
  std::thread thread_;
};

}  // namespace stepwire::realtime
