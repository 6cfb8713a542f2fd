#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/base/table/table.hpp"
#include "engine/base/table/table_file.hpp"
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

/// Returns the file of a folder that holds a recording: CSV, or HDF5 if there is no CSV. Throws Error without
/// either, since other formats do not have all bits and column names.
std::string recorded_file(const std::string& folder, std::size_t recording);

/// Reads the table of such a file, with its first signal at this column. On entry `words` has the columns
/// that may hold words, on return the words of those that do. Throws TableError, also for columns of
/// different lengths; EnvironmentError.
Recorded read_recorded(const std::string& file, std::size_t first_signal, table::ColumnWords& words);

/// Iterator over the runs of a sweep in the file of a recording.
class RecordedRuns {
 public:
  virtual ~RecordedRuns() = default;

  /// Returns the rows of the next run, valid until the next call. Throws Error if they do not have the
  /// columns of the plan's recording; TableError, EnvironmentError.
  virtual RecordedRows next() = 0;
  /// Marks the first `rows` rows of them as rows of the run.
  virtual void take(std::size_t rows) = 0;
  /// Returns a text on the first row that is in no run, with its place; an empty text without one.
  virtual std::string left_over() = 0;
};

/// Recorded sweep: its plan, its parameters and the number of its runs.
struct RecordedSweep {
  const plan::Plan& plan;
  const std::vector<std::string>& swept;  ///< columns, or values of each run
  std::size_t runs;
  const std::vector<std::size_t>* numbers = nullptr;  ///< indices of the runs, from 0; nullptr: all
};

/// Opens the file of a recording, recorded_file(), for a request of the plan. Text files are read as a whole,
/// HDF5 files some runs at a time. The objects in `sweep` must outlive it. Throws as next() does.
std::unique_ptr<RecordedRuns> open_recorded_runs(const std::string& file, std::size_t request,
                                                 const RecordedSweep& sweep);

}  // namespace stepwire::replay
