#include "engine/simulate/replay/kept_replay.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstdlib>

#include "engine/simulate/record/recorder.hpp"
#include "engine/simulate/replay/recorded_file.hpp"
#include "engine/simulate/run/number_row.hpp"

namespace stepwire::replay {

namespace {

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

}  // namespace

KeptTable read_kept_table(const std::string& file, const std::vector<std::string>& swept, std::size_t runs) {
  KeptTable kept;
  for (const std::string& parameter : swept) kept.words[parameter];
  kept.recorded = read_recorded(file, 1 + swept.size(), kept.words);
  auto& columns = kept.recorded.table.columns;
  if (kept.recorded.table.rows() != runs || columns.size() < kept.recorded.first_signal)
    throw yaml::Error(yaml::Fault{
        {file, {}}, "", fmt::format("has {} rows of {} runs", kept.recorded.table.rows(), runs), {}});
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
    verification.difference = difference_text(
        recorded, row, *column, number(0), number(*column == 0 ? 0 : *column - recorded.first_signal + 1));
}

}  // namespace stepwire::replay
