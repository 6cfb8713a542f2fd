#pragma once

#include <map>
#include <vector>

#include "engine/analyse/query/formula.hpp"
#include "engine/app/studio/live/sample_store.hpp"
#include "engine/app/studio/live/signal_list.hpp"

namespace stepwire::live {

/// Buffer that collects the stored values of each tick, and passes rows to the store in batches. Not
/// thread-safe, except for the store.
class RowGathering {
 public:
  /// Accessor of a column's value in the workspace of a run.
  struct Column {
    std::size_t offset = 0;                           ///< in a workspace
    std::optional<expression::Expression> formula{};  ///< of the numbers at `places`
    std::vector<std::size_t> places{};

    double operator()(const double* values) const {
      return formula ? (*formula)(values, places) : values[offset];
    }
  };
  /// Column of the store whose samples start after tick 0.
  struct Incomplete {
    std::size_t index = 0;
    std::int64_t first_tick = 0;
    Column column;
  };

  /// Stores the recorded signals of the file. The signals must outlive it.
  RowGathering(const SignalList& signals, double step, const StoreOptions& options);

  /// Returns the column of a signal in the store; a new column starts at `next_tick`.
  std::size_t column(std::size_t signal, std::int64_t next_tick);
  /// Returns the column of a formula over signals; it starts at the first tick at which all of them are
  /// stored.
  std::size_t column(const query::Formula& formula, std::int64_t next_tick);
  /// Returns the offsets in the workspace that the columns read.
  std::vector<std::size_t> places() const;
  /// Appends the row of a tick from the workspace of a run.
  void take(const double* values);
  /// Passes all rows to the store. Throws EnvironmentError.
  void flush();
  /// Removes all rows from a tick on.
  void cut(std::int64_t tick);
  std::vector<Incomplete> incomplete() const;
  /// Inserts the samples of all ticks before the first one of a column.
  void put_past(std::size_t column, std::span<const double> samples) { store_.put_before(column, samples); }

  const SampleStore& store() const { return store_; }

 private:
  std::size_t add(std::size_t offset, std::int64_t tick);
  void fill(std::size_t column, std::int64_t from, std::int64_t to);

  const SignalList& signals_;
  SampleStore store_;
  std::vector<Column> columns_;
  std::map<std::size_t, std::size_t> of_offset_;  ///< columns by offset
  std::map<std::string, std::size_t> of_formula_;
  std::vector<double> rows_;  ///< rows that the store does not have yet
};

}  // namespace stepwire::live
