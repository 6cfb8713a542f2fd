#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <mutex>
#include <span>
#include <string>
#include <vector>

#include "engine/app/studio/live/sample_column.hpp"
#include "engine/base/math/tick_times.hpp"

namespace stepwire::live {

/// Memory limits of a store.
struct StoreOptions {
  std::size_t chunks_in_memory = 16;           ///< full chunks of a column in memory: 65,536 samples
  std::size_t bytes = std::size_t{512} << 20;  ///< limit for all columns, which then keep fewer
  std::string folder{};                        ///< folder of the spill file; empty: temporary files
};

/// Request for samples of some columns: the ticks from, ..., to - 1.
struct SampleRange {
  std::vector<std::size_t> columns;
  std::int64_t from = 0, to = 0;
  std::size_t pixels = 1;
};

/// Decimated samples. Up to two samples per pixel they are complete, one row per tick. Beyond that a row has
/// the extremes of the ticks of one pixel, or down to half as many. Rows start at multiples of their width,
/// so that a scrolling view does not flicker.
struct SampleRows {
  bool extremes = false;
  std::vector<std::int64_t> ticks;           ///< first tick of each row
  std::int64_t end = 0;                      ///< tick after the last row
  std::vector<std::vector<double>> columns;  ///< values of each column, or its minima and its maxima
};

/// Statistics of the samples of a column in a range; NaN if there are none.
struct SampleStatistics {
  double least, most, mean, rms;
  double slope;  ///< of the least-squares line [1/tick]
  double first, last;
};

/// Samples of a run, a row per tick. One thread appends; reading is thread-safe.
class SampleStore {
 public:
  /// `step`: seconds per tick. Throws EnvironmentError.
  explicit SampleStore(double step, const StoreOptions& options = {});

  double time_of(std::int64_t tick) const { return times_(tick); }

  /// Adds a column whose samples start at a tick; returns its index.
  std::size_t add(std::int64_t tick);
  /// Appends complete rows, with one number per column. Throws EnvironmentError.
  void append(std::span<const double> rows);
  /// Appends like append() if the lock is free; otherwise returns false.
  bool try_append(std::span<const double> rows);
  /// Appends samples to a new column, up to the ticks of the others. Throws EnvironmentError.
  void append_to(std::size_t column, std::span<const double> samples);
  /// Inserts the samples of all ticks before the first one of a column; does nothing for another count.
  void put_before(std::size_t column, std::span<const double> samples);
  /// Removes all samples from a tick on.
  void cut(std::int64_t tick);
  /// Returns the number of put_before() calls that took effect.
  std::uint32_t revision() const;

  std::size_t columns() const;
  std::int64_t first_tick(std::size_t column) const;
  /// Returns the tick after the last row.
  std::int64_t end_tick() const;

  SampleRows look(const SampleRange& range) const;
  SampleStatistics statistics(std::size_t column, std::int64_t from, std::int64_t to) const;
  /// Copies samples from a tick on, as many as fit into `into`; missing ones are NaN.
  void read(std::size_t column, std::int64_t from, std::span<double> into) const;

 private:
  void append_locked(std::span<const double> rows);

  mutable std::mutex mutex_;
  TickTimes times_;
  StoreOptions options_;
  std::size_t in_memory_;  ///< chunks of each column
  SpillFile file_;
  std::deque<SampleColumn> columns_;
  std::uint32_t revision_ = 0;
};

}  // namespace stepwire::live
