#include "engine/view/plot/run_numbers.hpp"

#include <algorithm>
#include <cmath>

#include "engine/analyse/claim/run_formula.hpp"

namespace stepwire::plot {

namespace {

const yaml::Node& expression_of(const yaml::Node& node) {
  const yaml::Node* signal = node.is_map() ? node.find("signal") : nullptr;
  return signal ? *signal : node;
}

/// Returns the text before " in ", without the unit.
std::string without_unit(const std::string& text) {
  return text.substr(0, text.rfind(" in "));
}

/// Returns the rows that a condition selects, in their runs.
record::Recording selected(const record::Recording& all, const query::Formula& where) {
  const std::vector<double> holds = query::evaluate(where, all);
  record::Recording some{{}, {}, all.categories};
  for (const table::Column& column : all.table.columns)
    some.table.columns.push_back({column.name, column.unit, {}});
  std::size_t run = 0;
  for (std::size_t row = 0; row < holds.size(); ++row) {
    for (; run < all.starts.size() && all.starts[run] == row; ++run) some.starts.push_back(some.table.rows());
    if (holds[row] == 0.0 || std::isnan(holds[row])) continue;
    for (std::size_t i = 0; i < all.table.columns.size(); ++i)
      some.table.columns[i].values.push_back(all.table.columns[i].values[row]);
  }
  some.starts.resize(all.starts.size(), some.table.rows());
  return some;
}

/// Returns the rows of a run, [first, end).
std::pair<std::size_t, std::size_t> rows_of(const record::Recording& recording, std::size_t run) {
  const bool last = run + 1 == recording.starts.size();
  return {recording.starts[run], last ? recording.table.rows() : recording.starts[run + 1]};
}

/// Appends the values at the end of a run, without signals.
void append_end(const record::Recording& rows, std::size_t end, record::Recording& numbers) {
  for (std::size_t i = 0; i < numbers.table.columns.size(); ++i)
    if (const table::Column* column = rows.table.find(numbers.table.columns[i].name))
      numbers.table.columns[i].values.push_back(column->values[end - 1]);
}

}  // namespace

bool reduces_runs(const yaml::Node& node) {
  return claim::has_reduction(expression_of(node).text);
}

std::optional<query::Series> read_run_series(const yaml::Node& node, const query::NamesReading& read,
                                             Panel& panel) {
  yaml::Node formula = expression_of(node);
  const std::string text = without_unit(formula.text), behind = formula.text.substr(text.size());
  if (!read.names.unknown.empty())
    read.fault(formula.mark,
               "is a number of a run, which the sweep keeps: name it there, keep: {peak: max(x)}");
  formula.text = text;
  auto number = claim::read_run_formula(formula, read);
  if (!number) return std::nullopt;
  // As long as the expression, so that all positions stay.
  std::string name = "_" + std::to_string(panel.numbers.size());
  name.resize(std::max(name.size(), text.size()), '_');
  query::SymbolTable names = read.names;
  names.columns.push_back({name, number->formula->dimension, {}});
  names.columns.back().expression = text;
  yaml::Node named = formula;
  named.text = name + behind;
  auto series = query::read_series(named, names, read.subject, read.faults);
  if (!series) return std::nullopt;
  series->formula.text = series->label = text;
  if (const yaml::Node* label = node.is_map() ? node.find("label") : nullptr)
    series->label = read.text(*label);
  panel.numbers.push_back({name, std::move(*number)});
  return series;
}

namespace {

/// Returns the recordings with the rows that the panel selects.
std::vector<record::Recording> selected(const Panel& panel, std::span<const record::Recording> recordings) {
  std::vector<record::Recording> own(recordings.begin(), recordings.end());
  for (std::size_t i = 0; i < own.size(); ++i)
    if (panel.where->recording.value_or(i) == i && i == panel.recordings.front())
      own[i] = selected(own[i], *panel.where);
  return own;
}

/// Returns the columns, without rows, that accompany the numbers.
record::Recording beside_numbers(const Panel& panel, const record::Recording& rows) {
  record::Recording numbers{{}, {}, rows.categories};
  for (const std::string& name : panel.of_runs)
    if (const table::Column* column = rows.table.find(name))
      numbers.table.columns.push_back({name, column->unit, {}});
  return numbers;
}

record::Recording reduced(const Panel& panel, std::span<const record::Recording> recordings) {
  const record::Recording& rows = recordings[panel.recordings.front()];
  record::Recording numbers = beside_numbers(panel, rows);
  std::vector<std::vector<std::optional<double>>> values;
  std::vector<table::Column> made;
  for (const RunNumber& number : panel.numbers) {
    values.push_back(claim::values_of(number.formula, recordings));
    made.push_back({number.name, "", {}});
  }
  for (std::size_t run = 0; run < rows.starts.size(); ++run) {
    const auto [begin, end] = rows_of(rows, run);
    if (begin == end) continue;
    numbers.starts.push_back(made.front().values.size());
    append_end(rows, end, numbers);
    for (std::size_t i = 0; i < made.size(); ++i)
      made[i].values.push_back(values[i][run].value_or(query::nothing));
  }
  numbers.table.columns.insert(numbers.table.columns.end(), made.begin(), made.end());
  return numbers;
}

}  // namespace

record::Recording numbers_of_runs(const Panel& panel, std::span<const record::Recording> recordings) {
  if (!panel.where) return reduced(panel, recordings);
  return reduced(panel, selected(panel, recordings));
}

}  // namespace stepwire::plot
