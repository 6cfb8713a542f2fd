#include "engine/simulate/replay/run_replay.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <utility>

#include "engine/base/text/count.hpp"
#include "engine/simulate/record/recorder.hpp"
#include "engine/simulate/run/drive.hpp"
#include "engine/simulate/run/number_row.hpp"

namespace stepwire::replay {

namespace {

/// First difference in time among several tables.
class Earliest {
 public:
  void take(double time, std::string text) {
    if (!(time < time_)) return;
    time_ = time;
    text_ = std::move(text);
  }
  std::string text() const { return text_; }

 private:
  double time_ = std::numeric_limits<double>::infinity();
  std::string text_;
};

void compare(const RecordedRows& rows, const table::Table& computed, Earliest& earliest) {
  const Recorded& recorded = *rows.recorded;
  const std::size_t common = std::min(rows.count, computed.rows());
  for (std::size_t k = 0; k < common; ++k) {
    const auto number = [&](std::size_t i) { return computed.columns[i].values[k]; };
    if (const auto column = differing_column(recorded, rows.first + k, number)) {
      const std::size_t index = *column == 0 ? 0 : *column - recorded.first_signal + 1;
      return earliest.take(number(0),
                           difference_text(recorded, rows.first + k, *column, number(0), number(index)));
    }
  }
  if (rows.count <= common || common == 0) return;
  const double end = computed.columns.front().values[common - 1];
  earliest.take(std::nextafter(end, std::numeric_limits<double>::infinity()),
                extra_row_text(recorded, rows.first + common, end));
}

/// Returns the number of ticks until each table would have one more row, which shows whether the run
/// continued.
std::int64_t ticks_to_replay(const plan::Plan& plan, const std::vector<RecordedRows>& rows) {
  std::int64_t ticks = 0;
  if (plan.records_instants()) return plan.steps;
  for (std::size_t i = 0; i < rows.size(); ++i)
    ticks = std::max(ticks, static_cast<std::int64_t>(rows[i].count) *
                                record::ticks_between_rows(plan, plan.diagram.records[i]));
  return std::min(ticks, plan.steps);
}

/// Counts the rows that the replay has and the table has not. Returns the last tick at which the recorded run
/// may have ended before the first of them.
std::int64_t note_missing(const RecordedRows& rows, const plan::Plan& plan,
                          const diagram::RecordRequest& request, const table::Table& computed,
                          Verification& verification) {
  verification.missing_rows +=
      (request.instants ? computed.rows() : record::max_rows(plan, request)) - rows.count;
  const double time = computed.columns.front().values[rows.count];
  if (verification.first_missing.empty())
    verification.first_missing = fmt::format("{}: the row at {} s is missing",
                                             place_of_row(*rows.recorded, rows.first + rows.count), time);
  const auto tick = static_cast<std::int64_t>(std::ceil(time / plan.time_of(1) - 1e-6));
  return std::min(tick, plan.steps - 1);
}

/// Ends a run after a tick.
class UntilTick : public run::RunObserver {
 public:
  explicit UntilTick(std::int64_t last) : last_(last) {}
  run::Flow before_tick(const run::ObservedRun& run) override {
    return run.simulation.tick() > last_ ? run::Flow::stop : run::Flow::go_on;
  }

 private:
  std::int64_t last_;
};

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

  /// Returns the tick of the last row; -1 without rows, and the largest one for a diagram without inputs.
  std::int64_t last_tick() const {
    if (sizes_.empty()) return std::numeric_limits<std::int64_t>::max();
    return cursor_.ticks.empty() ? -1 : cursor_.ticks.back();
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

  /// Leaves out the rows after the last one of the inputs. Returns their number.
  std::size_t leave_out_rows_without_inputs() {
    std::size_t left_out = 0;
    for (Cursor& cursor : cursors_)
      left_out += std::erase_if(cursor.ticks, [&](std::int64_t tick) { return tick > inputs_.last_tick(); });
    return left_out;
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

/// Replaces the words of a column by numbers if all of them are numbers.
void take_numbers(table::Column& column, table::ColumnWords& words) {
  std::vector<double> numbers;
  for (const std::string& word : words[column.name]) {
    char* end = nullptr;
    numbers.push_back(std::strtod(word.c_str(), &end));
    if (end == word.c_str() || *end != '\0') return;
  }
  words.erase(column.name);
  for (double& value : column.values) value = numbers[static_cast<std::size_t>(value)];
}

/// Returns a run's recordings with the swept parameters of a row of the table.
std::vector<record::Recording> with_swept(std::vector<record::Recording> run, const KeptTable& table,
                                          std::size_t row) {
  for (record::Recording& recording : run) {
    auto& columns = recording.table.columns;
    const std::size_t rows = recording.table.rows();
    for (std::size_t i = 1; i < table.recorded.first_signal; ++i) {
      const table::Column& swept = table.recorded.table.columns[i];
      columns.insert(columns.begin() + static_cast<std::ptrdiff_t>(i),
                     {swept.name, swept.unit, std::vector<double>(rows, swept.values[row])});
    }
  }
  return run;
}

/// Compares the recorded rows of one run with those computed now. Returns how many of them are used, per
/// recording. `ticks` becomes that of the first missing row.
std::vector<std::size_t> compare_rows(const std::vector<RecordedRows>& rows, const plan::Plan& plan,
                                      const std::vector<record::Recording>& recordings,
                                      Verification& verification, std::int64_t& ticks) {
  std::vector<std::size_t> used;
  Earliest earliest;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const table::Table& computed = recordings[i].table;
    // A run that ended before its first row has no rows: these are of the next one.
    used.push_back(computed.rows() == 0 ? 0 : rows[i].count);
    verification.rows += used.back();
    const RecordedRows own_rows{rows[i].recorded, rows[i].first, used.back()};
    if (computed.rows() > used.back())
      ticks = std::min(ticks, note_missing(own_rows, plan, plan.diagram.records[i], computed, verification));
    compare(own_rows, computed, earliest);
  }
  verification.difference = earliest.text();
  return used;
}

}  // namespace

std::vector<std::size_t> replay_run(run::Executor& simulation, const std::vector<RecordedRows>& rows,
                                    const run::RunOptions& options, Verification& verification) {
  const plan::Plan& plan = simulation.plan();
  UntilTick until(ticks_to_replay(plan, rows));
  run::RunOptions own = options;
  own.observers.push_back(&until);
  run::TieredExecution interpreted(run::ExecutionMode::interpreted, nullptr, {}, 0.0);
  record::RunRecording recording(plan);
  const run::RunEnd end = run::run_simulation(simulation, recording.recorders(), own, interpreted, 0, 0);
  const std::vector<record::Recording> recordings = recording.take();
  verification.interrupted = verification.interrupted || end.interrupted;
  if (verification.interrupted) return {};
  std::int64_t ticks = end.ticks;
  std::vector<std::size_t> used = compare_rows(rows, plan, recordings, verification, ticks);
  verification.ticks += ticks;
  return used;
}

void replay_last_row(run::Executor& simulation, const std::vector<Recorded>& tables, std::size_t row,
                     const run::RunOptions& options, Verification& verification) {
  run::TieredExecution interpreted(run::ExecutionMode::interpreted, nullptr, {}, 0.0);
  record::RunRecording recording(simulation.plan(), true);
  const run::RunEnd end = run::run_simulation(simulation, recording.recorders(), options, interpreted, 0, 0);
  verification.interrupted = verification.interrupted || end.interrupted;
  if (verification.interrupted) return;
  Earliest earliest;
  for (std::size_t i = 0; i < tables.size(); ++i) {
    ++verification.rows;
    if (!std::isnan(tables[i].times()[row]))
      compare({&tables[i], row, 1}, recording.finished()[i].table, earliest);
  }
  verification.difference = earliest.text();
}

void replay_loop(const plan::Plan& plan, const std::vector<Recorded>& tables, const std::string& inputs_file,
                 const run::RunOptions& options, Verification& verification) {
  LoopReplay replay(plan, tables, inputs_file);
  if (!verification.end_of_loop.empty()) verification.without_inputs = replay.leave_out_rows_without_inputs();
  replay.run(options, verification);
  replay.count_rows(verification);
}

KeptTable read_kept_table(const std::string& file, const std::vector<std::string>& swept, std::size_t runs) {
  KeptTable kept;
  for (const std::string& parameter : swept) kept.words[parameter];
  kept.recorded = read_recorded(file, 1 + swept.size(), kept.words);
  auto& columns = kept.recorded.table.columns;
  if (kept.recorded.table.rows() != runs || columns.size() < kept.recorded.first_signal)
    throw yaml::Error(
        yaml::Fault{{file, {}},
                    "",
                    fmt::format("has {} of {}", text::counted(kept.recorded.table.rows(), "row"),
                                text::counted(runs, "run")),
                    {}});
  for (std::size_t i = 1; i < kept.recorded.first_signal; ++i) {
    if (kept.recorded.has_lines) take_numbers(columns[i], kept.words);
    kept.swept.columns.push_back({columns[i].name, columns[i].unit, {}});
  }
  return kept;
}

void replay_numbers(run::Executor& simulation, const run::RunNumbers& numbers, const KeptTable& table,
                    std::size_t row, const run::RunOptions& options, Verification& verification) {
  run::TieredExecution interpreted(run::ExecutionMode::interpreted, nullptr, {}, 0.0);
  record::RunRecording recording(simulation.plan());
  const run::RunEnd end = run::run_simulation(simulation, recording.recorders(), options, interpreted, 0, 0);
  verification.interrupted = verification.interrupted || end.interrupted;
  if (verification.interrupted) return;
  ++verification.rows;
  const Recorded& recorded = table.recorded;
  if (std::isnan(recorded.times()[row])) return;
  const record::Recording computed = run::number_row(numbers, with_swept(recording.take(), table, row));
  const auto number = [&](std::size_t i) { return computed.table.columns[i].values.front(); };
  if (const auto column = differing_column(recorded, row, number))
    verification.difference = difference_text(recorded, row, *column, number(0),
                                              number(*column == 0 ? 0 : *column - recorded.first_signal + 1));
}

}  // namespace stepwire::replay
