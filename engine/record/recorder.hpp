#pragma once

#include <cstdint>
#include <vector>

#include "engine/plan/plan.hpp"
#include "engine/record/recording.hpp"

namespace stepwire {

/// Keeps chosen signals of one run at one period. All memory is taken at the start.
class Recorder {
 public:
  Recorder(const Plan& plan, const RecordRequest& request);

  /// Keeps the signals of this tick, if it is one of the recorder's.
  void record(std::int64_t tick, const double* values) {
    if (tick != next_tick_) return;
    next_tick_ += every_;
    double* row = rows_.data() + filled_ * offsets_.size();
    for (std::size_t i = 0; i < offsets_.size(); ++i) row[i] = values[offsets_[i]];
    ++filled_;
  }

  /// Period [ticks].
  std::int64_t every() const { return every_; }
  /// Goes back to just before a tick that was reached: what is recorded from there on replaces what was kept.
  void go_back_to(std::int64_t tick) {
    filled_ = static_cast<std::size_t>((tick + every_ - 1) / every_);
    next_tick_ = static_cast<std::int64_t>(filled_) * every_;
  }

  /// What was kept: "time" and the signals, a vector signal p as p.1, p.2, ...
  Recording take() const;

 private:
  struct Name {
    std::string name, unit;
  };

  std::int64_t every_, next_tick_ = 0;
  std::size_t filled_ = 0;
  std::vector<std::size_t> offsets_;  ///< in the workspace, the time first
  std::vector<Name> names_;
  std::vector<double> rows_;
};

/// Ticks between two rows of a recording.
std::int64_t ticks_between_rows(const Plan& plan, const RecordRequest& request);

/// Names and dimensions of the columns that a request records, in order, the time first.
struct RecordedColumn {
  std::string name;
  std::optional<Dimension> dimension;
  std::size_t offset;  ///< in the workspace
};
std::vector<RecordedColumn> recorded_columns(const Plan& plan, const RecordRequest& request);

}  // namespace stepwire
