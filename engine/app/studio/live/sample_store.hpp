#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <mutex>
#include <span>
#include <string>
#include <vector>

#include "engine/app/studio/live/sample_column.hpp"

namespace stepwire::live {

/// How much of a run lies where.
struct StoreOptions {
  std::size_t chunks_in_memory = 16;  ///< of a column beside the one that is filled: 65,536 samples
  std::size_t bytes = std::size_t{512}
                      << 20;  ///< for these of all columns, which have fewer if they are many
  std::string folder{};       ///< for the file of all others; empty: that of temporary files
};

/// What of some columns is to be seen: the ticks from, from + 1, ..., to - 1.
struct SampleRange {
  std::vector<std::size_t> columns;
  std::int64_t from = 0, to = 0;
  std::size_t pixels = 1;
};

/// What is to be seen of them. Of few samples all, one row for each tick; of more than two for a pixel the
/// extremes of as many ticks side by side as one pixel has, or down to half as many: rows begin at multiples
/// of that count, so that a view which moves on does not flicker.
struct SampleRows {
  bool extremes = false;
  std::vector<std::int64_t> ticks;           ///< the first one of each row
  std::int64_t end = 0;                      ///< the tick behind the last row
  std::vector<std::vector<double>> columns;  ///< for each asked for its values, or its minima and its maxima
};

/// Of all samples of a column in a range. All nan where there are none.
struct SampleStatistics {
  double least, most, mean, rms;
  double slope;  ///< of the line that fits best [1/tick]
  double first, last;
};

/// The samples of a run, a row for each tick. What is appended by one thread is seen by all.
class SampleStore {
 public:
  /// `step`: seconds of a tick. Throws EnvironmentError.
  explicit SampleStore(double step, const StoreOptions& options = {});

  double time_of(std::int64_t tick) const { return static_cast<double>(tick) * step_; }

  /// A new column, whose samples begin at a tick.
  std::size_t add(std::int64_t tick);
  /// Rows of numbers, one for each column; as many as are given whole. Throws EnvironmentError.
  void append(std::span<const double> rows);
  /// The same where nobody is looking; else false.
  bool try_append(std::span<const double> rows);
  /// Samples that a new column has of ticks for which the others have theirs. Throws EnvironmentError.
  void append_to(std::size_t column, std::span<const double> samples);
  /// Puts the samples of all ticks before the first one of a column; ignores another number of samples.
  void put_before(std::size_t column, std::span<const double> samples);
  /// Forgets all from a tick on.
  void cut(std::int64_t tick);
  /// Counts how often samples of the past were put.
  std::uint32_t revision() const;

  std::size_t columns() const;
  std::int64_t first_tick(std::size_t column) const;
  /// The tick behind the last row.
  std::int64_t end_tick() const;

  SampleRows look(const SampleRange& range) const;
  SampleStatistics statistics(std::size_t column, std::int64_t from, std::int64_t to) const;
  /// Samples from a tick on, as many as `into` has; nan where there are none.
  void read(std::size_t column, std::int64_t from, std::span<double> into) const;

 private:
  void append_locked(std::span<const double> rows);

  mutable std::mutex mutex_;
  double step_;
  StoreOptions options_;
  std::size_t in_memory_;  ///< chunks of each column
  SpillFile file_;
  std::deque<SampleColumn> columns_;
  std::uint32_t revision_ = 0;
};

}  // namespace stepwire::live
