#include "engine/app/session/cases_table.hpp"

#include <algorithm>

namespace stepwire::session {

namespace {

/// True if the column is set by the cases of the sweep, so that it has one value in each case.
bool is_of_cases(const diagram::Sweep& sweep, const std::string& column) {
  return std::ranges::any_of(sweep.axes, [&](const diagram::Sweep::Axis& axis) {
    return axis.of_cases() && axis.parameter == column;
  });
}

bool is_kept(const run::RunNumbers& kept, const std::string& column) {
  return std::ranges::find(kept.columns, column, &table::Column::name) != kept.columns.end();
}

/// Returns `count` numbers: every `step`-th one from index `first` on.
std::vector<double> every(const std::vector<double>& all, std::size_t step, std::size_t first,
                          std::size_t count) {
  std::vector<double> some(count);
  for (std::size_t i = 0; i < count; ++i) some[i] = all[first + i * step];
  return some;
}

}  // namespace

void name_cases(const diagram::Sweep& sweep, const run::RunNumbers& kept, query::SymbolTable& names) {
  const std::vector<std::string> cases = sweep.cases();
  if (cases.empty()) return;
  std::vector<query::RecordedName> all;
  for (const query::RecordedName& column : names.columns) {
    if (is_of_cases(sweep, column.name)) continue;
    if (!is_kept(kept, column.name)) {
      all.push_back(column);
      continue;
    }
    for (const std::string& one : cases) {
      all.push_back(column);
      all.back().name = one + "." + column.name;
    }
  }
  names.columns = std::move(all);
}

record::Recording by_cases(const diagram::Sweep& sweep, const run::RunNumbers& kept,
                           const record::Recording& runs) {
  const std::vector<std::string> cases = sweep.cases();
  const bool whole = static_cast<double>(runs.table.rows()) == sweep.count();
  const std::size_t rows = whole ? runs.table.rows() / cases.size() : 0;
  record::Recording all{{}, {}, runs.categories};
  const auto add = [&](const table::Column& column, const std::string& name, std::size_t first) {
    all.table.columns.push_back({name, column.unit, every(column.values, cases.size(), first, rows)});
  };
  for (const table::Column& column : runs.table.columns) {
    if (!is_kept(kept, column.name)) {
      if (!is_of_cases(sweep, column.name)) add(column, column.name, 0);
      continue;
    }
    for (std::size_t i = 0; i < cases.size(); ++i) add(column, cases[i] + "." + column.name, i);
  }
  for (std::size_t row = 0; row < rows; ++row) all.starts.push_back(row);
  return all;
}

}  // namespace stepwire::session
