#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "engine/model/plan/plan.hpp"
#include "engine/simulate/record/recording.hpp"

namespace stepwire::record {

/// Recorded column, with the place of its numbers in the workspace.
struct RecordedColumn {
  std::string name;  ///< "time", or a signal; a vector signal p has p.1, p.2, ...
  std::optional<unit::Dimension> dimension;
  std::size_t offset;
  std::optional<double> zeros_if_kelvin{};  ///< see Diagram::zeros_if_kelvin
};
/// Returns the columns in order, the time first.
std::vector<RecordedColumn> recorded_columns(const plan::Plan& plan, const diagram::RecordRequest& request);

/// Returns the number of ticks between two rows; 1 if both sides of instants are recorded.
std::int64_t ticks_between_rows(const plan::Plan& plan, const diagram::RecordRequest& request);
/// Returns the number of rows of a run that reaches its stop time. The last tick always has a row. There may
/// be more with both sides of instants.
std::size_t max_rows(const plan::Plan& plan, const diagram::RecordRequest& request);
/// Returns the columns with names and units, without rows.
std::vector<table::Column> empty_columns(const plan::Plan& plan, const diagram::RecordRequest& request);

/// Writes chosen signals of one run with one period, or on both sides of each instant. Each number is written
/// directly to its final place.
class Recorder {
 public:
  /// Number of rows that are allocated at a time, so that a long run begins and ends early without touching
  /// all memory.
  static constexpr std::size_t rows_at_once = 65'536;

  /// Writes from the first row of these columns, which have capacity for max_rows().
  Recorder(const plan::Plan& plan, const diagram::RecordRequest& request, std::vector<double*> columns);
  /// Writes from the first row of these columns. They grow up to their capacity without reallocation; those
  /// for both sides of instants grow beyond it.
  Recorder(const plan::Plan& plan, const diagram::RecordRequest& request,
           std::vector<std::vector<double>*> columns);

  /// Records the signals of a tick if it is due or the last tick of the run.
  void record(std::int64_t tick, const double* values, bool last = false) {
    if (records_instants()) return record_side(values, Side::after);
    if (tick != next_tick_ && !last) return;
    next_tick_ += every_;
    if (filled_ == ready_) make_ready(1);
    for (std::size_t i = 0; i < offsets_.size(); ++i) columns_[i][filled_] = values[offsets_[i]];
    ++filled_;
  }

  bool records_instants() const { return instants_; }
  enum class Side { before, after };
  /// Records the signals of one side of an instant. The side after it is recorded once, also if the run ends
  /// there.
  void record_side(const double* values, Side side);

  /// Keeps only the last row of the run from now on.
  void keep_last_only() {
    last_only_ = true;
    next_tick_ = -1;
  }
  bool keeps_last_only() const { return last_only_; }
  /// Records rows of the recorder's next ticks, in order; successive numbers are `stride` apart.
  void record_rows(const double* numbers, std::size_t rows, std::size_t stride) {
    if (last_only_) return;
    make_ready(rows);
    for (std::size_t i = 0; i < columns_.size(); ++i)
      for (std::size_t row = 0; row < rows; ++row)
        columns_[i][filled_ + row] = numbers[(row * columns_.size() + i) * stride];
    filled_ += rows;
    next_tick_ += static_cast<std::int64_t>(rows) * every_;
  }
  /// Returns the count of numbers in a row.
  std::size_t columns() const { return columns_.size(); }

  /// Returns the period [ticks].
  std::int64_t every() const { return every_; }
  /// Returns the number of rows so far.
  std::size_t rows() const { return filled_; }
  /// Restarts after the columns were cleared.
  void restart() {
    ready_ = 0;
    go_back_to(0);
    if (!records_instants()) make_ready(1);
  }
  /// Returns to just before an earlier tick. Later records replace the rows from there on.
  void go_back_to(std::int64_t tick) {
    if (records_instants()) return go_back_to_side(tick);
    if (last_only_) {
      filled_ = 0;
      return keep_last_only();
    }
    filled_ = static_cast<std::size_t>((tick + every_ - 1) / every_);
    next_tick_ = static_cast<std::int64_t>(filled_) * every_;
  }

 private:
  void go_back_to_side(std::int64_t tick);
  /// Extends the columns by at least `rows` rows.
  void make_ready(std::size_t rows);

  bool last_only_ = false;
  Side side_ = Side::before;  ///< side of the last row
  TickTimes time_of_;
  std::int64_t every_, next_tick_ = 0;
  std::size_t filled_ = 0, ready_ = 0;
  bool instants_;                     ///< true if both sides of instants are recorded
  std::vector<std::size_t> offsets_;  ///< in the workspace, the time first
  std::vector<double*> columns_;
  std::vector<std::vector<double>*> grown_;  ///< owners of these columns, if they grow
};

/// Recordings of one run, or of several ones after each other, with their recorders.
class RunRecording {
 public:
  /// Records all rows, or the last one only.
  explicit RunRecording(const plan::Plan& plan, bool last_only = false);

  std::vector<Recorder>& recorders() { return recorders_; }
  const std::vector<Recorder>& recorders() const { return recorders_; }
  /// Moves the recordings out, one for each request.
  std::vector<Recording> take();
  /// Returns the recordings, valid until the next run restarts them.
  const std::vector<Recording>& finished();
  /// Prepares for another run of a plan with the same recordings.
  void restart();

 private:
  void add(const plan::Plan& plan, const diagram::RecordRequest& request, Recording& recording,
           std::size_t rows);

  std::vector<Recording> recordings_;
  std::vector<Recorder> recorders_;
};

}  // namespace stepwire::record
