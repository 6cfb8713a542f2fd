#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "engine/base/table/table.hpp"
#include "engine/simulate/record/recorder.hpp"

namespace stepwire::replay {

/// Table that a run has written into its folder.
struct Recorded {
  std::string file;  ///< path, for messages
  table::Table table;
  std::size_t first_signal = 1;  ///< column of the first signal; the time is column 0
  bool has_lines = true;         ///< true for a text file with a header line

  const std::vector<double>& times() const { return table.columns.front().values; }
  std::size_t signals() const { return table.columns.size() - first_signal; }
};

/// Successive rows of such a table.
struct RecordedRows {
  const Recorded* recorded = nullptr;
  std::size_t first = 0, count = 0;
};

/// True if both numbers have the same bits. All NaN are equal, since a table has only one.
bool same_bits(double a, double b);

/// Returns the column of the first number in a row that differs from the computed one, the time included.
/// Returns std::nullopt if all are equal. Argument `computed` returns a number by its index: 0 for the time,
/// and from 1 on the signals.
template <class Computed>
std::optional<std::size_t> differing_column(const Recorded& recorded, std::size_t row,
                                            const Computed& computed) {
  const auto& columns = recorded.table.columns;
  if (!same_bits(columns.front().values[row], computed(0))) return 0;
  for (std::size_t i = recorded.first_signal; i < columns.size(); ++i)
    if (!same_bits(columns[i].values[row], computed(i - recorded.first_signal + 1))) return i;
  return std::nullopt;
}

/// Returns "out/signals.csv:5203", or "out/signals.h5/run-2: row 17" for a binary file.
std::string place_of_row(const Recorded& recorded, std::size_t row);
/// Returns "out/signals.csv:5203: cart.position at 0.25 s is 0.1 m and 0.3 m when it is replayed".
std::string difference_text(const Recorded& recorded, std::size_t row, std::size_t column, double time,
                            double computed);
/// Returns the same for a row that the replay does not have.
std::string extra_row_text(const Recorded& recorded, std::size_t row, double end);

/// True if a table has the columns of a plan's recording after its first `first_signal` ones.
bool has_columns(const table::Table& table, std::size_t first_signal, const plan::Plan& plan,
                 const diagram::RecordRequest& request);
/// Throws Error for a table without these columns.
void require_columns(const Recorded& recorded, const plan::Plan& plan, const diagram::RecordRequest& request);

}  // namespace stepwire::replay
