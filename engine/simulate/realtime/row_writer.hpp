#pragma once

#include <condition_variable>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "engine/simulate/realtime/loop_recorder.hpp"
#include "engine/simulate/realtime/row_ring.hpp"

namespace stepwire::realtime {

/// Writes the rows of a ring into the files of a loop, in a thread of its own. The files get their names in
/// finish(); without it they are removed.
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
