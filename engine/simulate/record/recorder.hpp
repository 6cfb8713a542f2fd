#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "engine/model/plan/plan.hpp"
#include "engine/simulate/record/recording.hpp"

namespace stepwire::record {

/// A column that a request records: where its numbers lie in the workspace.
struct RecordedColumn {
  std::string name;  ///< "time", or a signal; a vector signal p makes p.1, p.2, ...
  std::optional<unit::Dimension> dimension;
  std::size_t offset;
};
/// In their order, the time first.
std::vector<RecordedColumn> recorded_columns(const plan::Plan& plan, const diagram::RecordRequest& request);

/// Ticks between two rows of a recording; 1 where both sides of instants are recorded.
std::int64_t ticks_between_rows(const plan::Plan& plan, const diagram::RecordRequest& request);
/// Rows of a run that goes on to its stop time, whose last tick makes one, too, where the period skips it.
/// With both sides of instants there may be more.
std::size_t max_rows(const plan::Plan& plan, const diagram::RecordRequest& request);
/// Columns without rows, with names and units.
std::vector<table::Column> empty_columns(const plan::Plan& plan, const diagram::RecordRequest& request);

/// Writes chosen signals of one run at one period, each number once: into the place where it stays. Or on
/// both sides of each instant.
class Recorder {
 public:
  /// Rows that are made ready at a time: a run of many rows begins, and ends early, without those that it
  /// lacks.
  static constexpr std::size_t rows_at_once = 65'536;

  /// Writes from the first row of these columns on, which have room for max_rows().
  Recorder(const plan::Plan& plan, const diagram::RecordRequest& request, std::vector<double*> columns);
  /// Writes from the first row of these columns on. They grow up to their capacity, where they stay; those
  /// for both sides of instants beyond it.
  Recorder(const plan::Plan& plan, const diagram::RecordRequest& request,
           std::vector<std::vector<double>*> columns);

  /// Keeps the signals of this tick, if it is one of the recorder's or the last one of the run.
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
  /// Keeps the signals of one side of an instant. That after it is kept once, also where the run ends there.
  void record_side(const double* values, Side side);

  /// Keeps the last row of the run alone, from now on.
  void keep_last_only() {
    last_only_ = true;
    next_tick_ = -1;
  }
  /// Keeps rows of the recorder's next ticks, one behind the other: numbers lie `stride` apart.
  void record_rows(const double* numbers, std::size_t rows, std::size_t stride) {
    if (last_only_) return;
    make_ready(rows);
    for (std::size_t i = 0; i < columns_.size(); ++i)
      for (std::size_t row = 0; row < rows; ++row)
        columns_[i][filled_ + row] = numbers[(row * columns_.size() + i) * stride];
    filled_ += rows;
    next_tick_ += static_cast<std::int64_t>(rows) * every_;
  }
  /// Numbers in a row.
  std::size_t columns() const { return columns_.size(); }

  /// Period [ticks].
  std::int64_t every() const { return every_; }
  /// Rows so far.
  std::size_t rows() const { return filled_; }
  /// Begins anew after a cut of the columns.
  void restart() {
    ready_ = 0;
    go_back_to(0);
    if (!records_instants()) make_ready(1);
  }
  /// Goes back to just before a tick that was reached: what is recorded from there on replaces what was kept.
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
  /// Lengthens the columns until `rows` more fit.
  void make_ready(std::size_t rows);

  bool last_only_ = false;
  Side side_ = Side::before;  ///< of the last row
  double step_;               ///< [s]
  std::int64_t every_, next_tick_ = 0;
  std::size_t filled_ = 0, ready_ = 0;
  bool instants_;                     ///< are both sides of instants recorded?
  std::vector<std::size_t> offsets_;  ///< in the workspace, the time first
  std::vector<double*> columns_;
  std::vector<std::vector<double>*> grown_;  ///< owners of these numbers, if they grow
};

/// The recordings of one run, or of several ones after each other, with their recorders.
class RunRecording {
 public:
  /// Of all rows, or of the last one alone.
  explicit RunRecording(const plan::Plan& plan, bool last_only = false);

  std::vector<Recorder>& recorders() { return recorders_; }
  const std::vector<Recorder>& recorders() const { return recorders_; }
  /// What was recorded, one for each request.
  std::vector<Recording> take();
  /// The same, to be looked at until the next run restarts it.
  const std::vector<Recording>& finished();
  /// Makes room for another run of a plan with the same recordings.
  void restart();

 private:
  void add(const plan::Plan& plan, const diagram::RecordRequest& request, Recording& recording,
           std::size_t rows);

  std::vector<Recording> recordings_;
  std::vector<Recorder> recorders_;
};

}  // namespace stepwire::record
