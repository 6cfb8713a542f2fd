#include "blocks/records/record.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/base/data_file/data_file.hpp"
#include "engine/base/yaml/error.hpp"

namespace stepwire {

std::optional<Index> first_uneven(std::span<const double> time) {
  const double interval = (time.back() - time.front()) / static_cast<double>(time.size() - 1);
  for (std::size_t row = 0; row < time.size(); ++row)
    if (std::abs(time[row] - (time.front() + static_cast<double>(row) * interval)) > 1e-3 * interval)
      return static_cast<Index>(row);
  return std::nullopt;
}

double Record::interval() const {
  Index steps = 0;
  for (std::size_t row = 1; row < time.size(); ++row) steps += time[row] != time[row - 1] ? 1 : 0;
  return (time.back() - time.front()) / static_cast<double>(steps);
}

std::string place_in_file(const std::string& file, const table::RecordTable& table, const std::string& column,
                          std::size_t row) {
  return data_file::has_lines(file) ? fmt::format("{}:{}: {}", file, table.line_of(row), column)
                                    : fmt::format("{}: element {} of {}", file, row + 1, column);
}

std::optional<std::size_t> first_missing(const std::vector<double>& values,
                                         const std::vector<std::size_t>& rows) {
  const auto at = std::ranges::find_if(rows, [&](std::size_t row) { return std::isnan(values[row]); });
  return at == rows.end() ? std::nullopt : std::optional(*at);
}

std::string missing_value(const Record& record, const std::string& column, std::size_t row) {
  return fmt::format(
      "{} has no value{}", place_in_file(record.file, *record.table, column, row),
      record.hold_missing
          ? ", and no row before it has one to hold; leave the row out by `missing: skip` or `from`"
          : "; say `missing: hold` for the value before it, or `missing: skip` to leave the row out");
}

std::vector<double> values_of_rows(const table::Column& column, const std::vector<std::size_t>& rows,
                                   bool hold) {
  std::vector<double> values;
  values.reserve(rows.size());
  for (const std::size_t row : rows) {
    const double value = column.values[row];
    values.push_back(std::isnan(value) && hold && !values.empty() ? values.back() : value);
  }
  return values;
}

std::string no_column(const std::string& file, const table::Table& table, const std::string& name) {
  std::vector<std::string> names;
  for (const table::Column& column : table.columns) names.push_back(column.name);
  return fmt::format(
      "{} has no column '{}'{}", file, name,
      yaml::did_you_mean(name, names, fmt::format("It has: {}", fmt::join(names, ", "))).text());
}

}  // namespace stepwire
