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
/// finish(); without it nothing of them is left.
class RowWriter {
 public:
  /// Throws EnvironmentError where a file cannot be made.
  RowWriter(RowRing& ring, const std::string& folder, const std::vector<LoopFile>& files);
  ~RowWriter();
  RowWriter(const RowWriter&) = delete;
  RowWriter& operator=(const RowWriter&) = delete;

  /// Writes what is left in the ring, into which nobody puts any more, and names the files. Throws
  /// EnvironmentError where that fails.
  void finish();

  /// After finish(): rows that are in the files, and rows that the disk did not take.
  std::int64_t rows() const { return rows_; }
  std::int64_t lost() const { return lost_; }
  /// What the system said to the first row that the disk did not take; empty if it took all.
  std::string trouble() const;

 private:
  class Sink;

  void work();
  void stop();
  bool take();

  RowRing& ring_;
  std::vector<std::unique_ptr<Sink>> sinks_;
  std::vector<double> numbers_;  ///< taken from the ring; a row whose end has not come waits at the front
  std::size_t filled_ = 0;
  std::int64_t rows_ = 0, lost_ = 0;
  std::mutex mutex_;  ///< between finish() and the writing thread; the loop thread knows nothing of it
  std::condition_variable ended_;
  bool ending_ = false;
  std::thread thread_;
};

}  // namespace stepwire::realtime
