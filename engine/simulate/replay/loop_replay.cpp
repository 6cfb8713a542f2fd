#include "engine/simulate/replay/loop_replay.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/base/table/table_file.hpp"
#include "engine/simulate/run/drive.hpp"

namespace stepwire::replay {

namespace {

[[noreturn]] void refuse(const std::string& file, std::size_t row, std::string message) {
  throw yaml::Error(yaml::Fault{{file, {static_cast<int>(row) + 2, 1}}, "", std::move(message), {}});
}

/// Returns the column `tick`, which must have increasing integers.
std::vector<std::int64_t> ticks_of(const std::string& file, const table::Table& table) {
  std::vector<std::int64_t> ticks;
  for (const double value : table.columns[1].values) {
    const bool whole = value >= 0.0 && value < 9e15 && value == std::floor(value);
    if (!whole || (!ticks.empty() && value <= static_cast<double>(ticks.back())))
      refuse(file, ticks.size(),
             fmt::format("tick {} is no whole number above that of the row before", value));
    ticks.push_back(static_cast<std::int64_t>(value));
  }
  return ticks;
}

/// Rows of a table with an increasing tick, and the next one of them.
struct Cursor {
  std::vector<std::int64_t> ticks;
  std::size_t row = 0;

  bool is_at(std::int64_t tick) const { return row < ticks.size() && ticks[row] == tick; }
  bool ended() const { return row == ticks.size(); }
};

/// Recorded inputs of a diagram.
class Inputs {
 public:
  Inputs(const plan::Plan& plan, const std::string& file) {
    if (plan.diagram.inputs.empty()) return;
    table::ColumnWords no_words;
    table_ = table::read_csv(file, no_words);
    require_names(plan, file);
    cursor_.ticks = ticks_of(file, table_);
    for (const diagram::DiagramInput& input : plan.diagram.inputs)
      sizes_.push_back(static_cast<std::size_t>(plan.slot({input.block, 0}).size));
    numbers_.resize(table_.columns.size());
  }

  void write(run::Executor& simulation) {
    if (!cursor_.is_at(simulation.tick())) return;
    for (std::size_t i = 0; i < numbers_.size(); ++i) numbers_[i] = table_.columns[i].values[cursor_.row];
    std::size_t column = 2;
    for (std::size_t input = 0; input < sizes_.size(); column += sizes_[input++])
      simulation.write_input(input, &numbers_[column]);
    ++cursor_.row;
  }

 private:
  void require_names(const plan::Plan& plan, const std::string& file) const {
    std::vector<std::string> wanted{"time", "tick"}, found;
    for (const diagram::DiagramInput& input : plan.diagram.inputs) {
      const Eigen::Index size = plan.slot({input.block, 0}).size;
      for (Eigen::Index k = 0; k < size; ++k)
        wanted.push_back(size == 1 ? input.name : fmt::format("{}.{}", input.name, k + 1));
    }
    for (const table::Column& column : table_.columns) found.push_back(column.name);
    if (found != wanted)
      throw yaml::Error(
          yaml::Fault{{file, {1, 1}},
                      "",
                      fmt::format("its columns are {}; the inputs of {} make {}", fmt::join(found, ", "),
                                  plan.diagram.file, fmt::join(wanted, ", ")),
                      {}});
  }

  table::Table table_;
  Cursor cursor_;
  std::vector<std::size_t> sizes_;
  std::vector<double> numbers_;
};

/// Replay of a loop: it writes the recorded inputs before each tick, and compares the rows after it.
class LoopReplay : run::RunObserver {
 public:
  LoopReplay(const plan::Plan& plan, const std::vector<Recorded>& tables, const std::string& inputs_file)
      : simulation_(plan), tables_(tables), inputs_(plan, inputs_file) {
    simulation_.go_on_unsolved();
    for (std::size_t i = 0; i < tables.size(); ++i) {
      cursors_.push_back({ticks_of(tables[i].file, tables[i].table)});
      columns_.push_back(record::recorded_columns(plan, plan.diagram.records[i]));
    }
  }

  void run(const run::RunOptions& options, Verification& verification) {
    run::RunObserver* const self = this;
    std::vector<record::Recorder> nothing_recorded;
    run::Drive drive(simulation_, nothing_recorded);
    drive.observers = {&self, 1};
    drive.shows_rows = drive.ends = false;
    drive.interrupt = options.interrupt;
    const run::Drive::End end = drive.run();
    verification.interrupted = end == run::Drive::End::interrupted;
    // A tick whose outputs are not finite is not passed to observers.
    if (end == run::Drive::End::finished && simulation_.tick() == begun_) difference_ = compare();
    if (end == run::Drive::End::finished && difference_.empty()) difference_ = row_beyond();
    verification.difference = difference_;
  }

  void count_rows(Verification& verification) const {
    const plan::Plan& plan = simulation_.plan();
    for (std::size_t i = 0; i < cursors_.size(); ++i) {
      const auto& ticks = cursors_[i].ticks;
      verification.rows += ticks.size();
      if (ticks.empty()) continue;
      const auto whole =
          static_cast<std::size_t>(ticks.back() / record::ticks_between_rows(plan, plan.diagram.records[i])) +
          1;
      verification.missing_rows += whole - std::min(whole, ticks.size());
    }
  }

 private:
  run::Flow before_tick(const run::ObservedRun&) override {
    if (all_ended() || !difference_.empty()) return run::Flow::stop;
    inputs_.write(simulation_);
    begun_ = simulation_.tick();
    return run::Flow::go_on;
  }
  void evaluated(const run::ObservedRun&) override { difference_ = compare(); }

  bool all_ended() const {
    return std::all_of(cursors_.begin(), cursors_.end(), [](const Cursor& cursor) { return cursor.ended(); });
  }

  /// Compares the rows of this tick in all tables. Returns the text of the first difference.
  std::string compare() {
    for (std::size_t i = 0; i < tables_.size(); ++i) {
      if (!cursors_[i].is_at(simulation_.tick())) continue;
      const auto number = [&](std::size_t column) {
        return simulation_.values()[columns_[i][column].offset];
      };
      const std::size_t row = cursors_[i].row++;
      if (const auto column = differing_column(tables_[i], row, number)) {
        const std::size_t index = *column == 0 ? 0 : *column - tables_[i].first_signal + 1;
        return difference_text(tables_[i], row, *column, simulation_.time(), number(index));
      }
    }
    return "";
  }

  /// Returns the text of the first row that is left at the end of the replay.
  std::string row_beyond() const {
    for (std::size_t i = 0; i < tables_.size(); ++i)
      if (!cursors_[i].ended()) return extra_row_text(tables_[i], cursors_[i].row, simulation_.time());
    return "";
  }

  run::Executor simulation_;
  const std::vector<Recorded>& tables_;
  Inputs inputs_;
  std::vector<Cursor> cursors_;
  std::vector<std::vector<record::RecordedColumn>> columns_;
  std::int64_t begun_ = 0;  ///< tick that is being computed
  std::string difference_;
};

}  // namespace

void replay_loop(const plan::Plan& plan, const std::vector<Recorded>& tables, const std::string& inputs_file,
                 const run::RunOptions& options, Verification& verification) {
  LoopReplay replay(plan, tables, inputs_file);
  replay.run(options, verification);
  replay.count_rows(verification);
}

}  // namespace stepwire::replay
