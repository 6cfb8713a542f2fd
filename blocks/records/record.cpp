#include "blocks/records/record.hpp"

#include <fmt/format.h>

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

std::string place_in_file(const std::string& file, const std::string& column, std::size_t row) {
  return data_file::has_lines(file) ? fmt::format("{}:{}: {}", file, row + 2, column)
                   : fmt::format("{}: element {} of {}", file, row + 1, column);
}

std::string no_column(const std::string& file, const table::Table& table, const std::string& name) {
  std::vector<std::string> names;
  for (const table::Column& column : table.columns) names.push_back(column.name);
  return fmt::format(
      "{} has no column '{}'{}", file, name,
      yaml::did_you_mean(name, names, fmt::format("It has: {}", fmt::join(names, ", "))).text());
}

}  // namespace stepwire
