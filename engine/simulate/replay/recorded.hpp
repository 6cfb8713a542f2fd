#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "engine/base/table/table.hpp"
#include "engine/simulate/record/recorder.hpp"

namespace stepwire::replay {

/// A table that a run left in its folder.
struct Recorded {
  std::string file;  ///< its path, for messages
  table::Table table;
  std::size_t first_signal = 1;  ///< column of the first signal; the time is column 0
  bool has_lines = true;         ///< it is a text, with a header as its first line

  const std::vector<double>& times() const { return table.columns.front().values; }
  std::size_t signals() const { return table.columns.size() - first_signal; }
};

/// Rows of such a table, one behind the other.
struct RecordedRows {
  const Recorded* recorded = nullptr;
  std::size_t first = 0, count = 0;
};

/// Is this the same bit for bit? One nan is like another: a table does not tell them apart.
bool same_bits(double a, double b);

/// The first of a row's signals that is not what was computed, the time included, as its column; `computed`
/// gives the numbers by their index among the signals from 1, the time being 0. Nothing where all are.
template <class Computed>
std::optional<std::size_t> differing_column(const Recorded& recorded, std::size_t row,
                                            const Computed& computed) {
  const auto& columns = recorded.table.columns;
  if (!same_bits(columns.front().values[row], computed(0))) return 0;
  for (std::size_t i = recorded.first_signal; i < columns.size(); ++i)
    if (!same_bits(columns[i].values[row], computed(i - recorded.first_signal + 1))) return i;
  return std::nullopt;
}

/// "out/signals.csv:5203", or "out/signals.h5/run-2: row 17" of what is no text.
std::string place_of_row(const Recorded& recorded, std::size_t row);
/// "out/signals.csv:5203: cart.position at 0.25 s is 0.1 m and 0.3 m when it is replayed".
std::string difference_text(const Recorded& recorded, std::size_t row, std::size_t column, double time,
                            double computed);
/// The same for a row that the replay does not have.
std::string extra_row_text(const Recorded& recorded, std::size_t row, double end);

/// Does a table have these columns of a plan's recording behind its first `first_signal` ones?
bool has_columns(const table::Table& table, std::size_t first_signal, const plan::Plan& plan,
                 const diagram::RecordRequest& request);
/// Refuses, as an Error, a table that has not.
void require_columns(const Recorded& recorded, const plan::Plan& plan, const diagram::RecordRequest& request);

}  // namespace stepwire::replay
