#include "engine/analyse/study/repetition.hpp"

#include <fmt/format.h>

#include "engine/base/table/table_file.hpp"

namespace stepwire::study {

void Repetition::read(const std::string& path) {
  const table::Table table = table::read_csv(path);
  std::vector<std::string> wanted{"seed", "point"}, there;
  for (const OutcomeColumn& column : columns_) wanted.push_back(column.name);
  for (const table::Column& column : table.columns) there.push_back(column.name);
  if (there != wanted)
    throw table::TableError(fmt::format("{}:1: these are no experiments of this study, whose columns are {}",
                                        path, fmt::join(wanted, ", ")));
  for (std::size_t row = 0; row < table.rows(); ++row) {
    std::vector<double> values;
    for (const table::Column& column : table.columns) values.push_back(column.values[row]);
    const std::pair key{static_cast<std::uint64_t>(values[0]), static_cast<std::size_t>(values[1]) - 1};
    rows_[key].assign(values.begin() + 2, values.end());
  }
}

std::string Repetition::csv() const {
  table::Table table{{{"seed", "", {}}, {"point", "", {}}}};
  for (const OutcomeColumn& column : columns_) table.columns.push_back({column.name, column.unit, {}});
  for (const auto& [key, values] : rows_) {
    table.columns[0].values.push_back(static_cast<double>(key.first));
    table.columns[1].values.push_back(static_cast<double>(key.second + 1));
    for (std::size_t i = 0; i < columns_.size(); ++i) table.columns[2 + i].values.push_back(values[i]);
  }
  return table::csv_text(table);
}

bool Repetition::has(std::uint64_t seed, std::size_t points) const {
  for (std::size_t point = 0; point < points; ++point)
    if (!rows_.contains({seed, point})) return false;
  return true;
}

void Repetition::add(const ExperimentOutcome& outcome, std::size_t point) {
  std::vector<double> values;
  for (const OutcomeColumn& column : columns_) values.push_back(value_of(outcome.values, column.name));
  rows_[{outcome.seed, point}] = std::move(values);
}

std::vector<ExperimentOutcome> Repetition::outcomes(std::size_t point) const {
  std::vector<ExperimentOutcome> all;
  for (const auto& [key, values] : rows_) {
    if (key.second != point) continue;
    all.push_back({key.first, {}});
    for (std::size_t i = 0; i < columns_.size(); ++i)
      all.back().values.push_back({columns_[i].name, values[i]});
  }
  return all;
}

}  // namespace stepwire::study
