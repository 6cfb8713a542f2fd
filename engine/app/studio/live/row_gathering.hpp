#pragma once

#include <map>
#include <vector>

#include "engine/analyse/query/formula.hpp"
#include "engine/app/studio/live/sample_store.hpp"
#include "engine/app/studio/live/signal_list.hpp"

namespace stepwire::live {

/// Gathers what is stored of each tick, and hands rows to the store many at a time. For one thread, but for
/// the store.
class RowGathering {
 public:
  /// How the value of a column is read from the numbers of a run.
  struct Column {
    std::size_t offset = 0;                           ///< in a workspace
    std::optional<expression::Expression> formula{};  ///< of numbers at these places
    std::vector<std::size_t> places{};

    double operator()(const double* values) const {
      return formula ? (*formula)(values, places) : values[offset];
    }
  };
  /// A column of the store whose samples begin behind tick 0.
  struct Incomplete {
    std::size_t index = 0;
    std::int64_t first_tick = 0;
    Column column;
  };

  /// Stores what the file records. The signals must outlive it.
  RowGathering(const SignalList& signals, double step, const StoreOptions& options);

  /// The column of the store that has a signal; one that is not stored yet begins at this tick, which is
  /// computed next.
  std::size_t column(std::size_t signal, std::int64_t next_tick);
  /// The same for a formula over signals, as far back as all of them are stored.
  std::size_t column(const query::Formula& formula, std::int64_t next_tick);
  /// Where in the numbers of a run lies what it takes.
  std::vector<std::size_t> places() const;
  /// Takes the row of a tick from the numbers of a run.
  void take(const double* values);
  /// Hands all rows to the store. Throws EnvironmentError.
  void flush();
  /// Forgets all from a tick on.
  void cut(std::int64_t tick);
  std::vector<Incomplete> incomplete() const;
  /// Puts the samples of all ticks before the first one of a column.
  void put_past(std::size_t column, std::span<const double> samples) { store_.put_before(column, samples); }

  const SampleStore& store() const { return store_; }

 private:
  std::size_t add(std::size_t offset, std::int64_t tick);
  void fill(std::size_t column, std::int64_t from, std::int64_t to);

  const SignalList& signals_;
  SampleStore store_;
  std::vector<Column> columns_;
  std::map<std::size_t, std::size_t> of_offset_;  ///< column of the number that lies there
  std::map<std::string, std::size_t> of_formula_;
  std::vector<double> rows_;  ///< that the store has not
};

}  // namespace stepwire::live
