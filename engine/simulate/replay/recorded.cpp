#include "engine/simulate/replay/recorded.hpp"

#include <fmt/format.h>

#include <bit>
#include <cmath>

namespace stepwire::replay {

namespace {

std::string title(const table::Column& column) {
  return column.unit.empty() ? column.name : fmt::format("{} [{}]", column.name, column.unit);
}

std::vector<std::string> titles(const plan::Plan& plan, const diagram::RecordRequest& request) {
  std::vector<std::string> result;
  for (const record::RecordedColumn& column : record::recorded_columns(plan, request))
    result.push_back(title({column.name, column.dimension ? unit::si_name(*column.dimension) : "", {}}));
  return result;
}

}  // namespace

bool same_bits(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b) ||
         (std::isnan(a) && std::isnan(b));
}

std::string place_of_row(const Recorded& recorded, std::size_t row) {
  return recorded.has_lines ? fmt::format("{}:{}", recorded.file, row + 2)
                            : fmt::format("{}: row {}", recorded.file, row + 1);
}

std::string difference_text(const Recorded& recorded, std::size_t row, std::size_t column, double time,
                            double computed) {
  const table::Column& found = recorded.table.columns[column];
  return fmt::format("{}: {} at {} s is {} and {} when it is replayed", place_of_row(recorded, row), found.name,
                     time, found.values[row], computed);
}

std::string extra_row_text(const Recorded& recorded, std::size_t row, double end) {
  return fmt::format("{}: there is a row at {} s, but the replay ends at {} s", place_of_row(recorded, row),
                     recorded.times()[row], end);
}

bool has_columns(const table::Table& table, std::size_t first_signal, const plan::Plan& plan,
                 const diagram::RecordRequest& request) {
  const std::vector<std::string> wanted = titles(plan, request);
  if (table.columns.size() + 1 != first_signal + wanted.size()) return false;
  if (title(table.columns.front()) != wanted.front()) return false;
  for (std::size_t i = 1; i < wanted.size(); ++i)
    if (title(table.columns[first_signal + i - 1]) != wanted[i]) return false;
  return true;
}

void require_columns(const Recorded& recorded, const plan::Plan& plan,
                     const diagram::RecordRequest& request) {
  if (has_columns(recorded.table, recorded.first_signal, plan, request)) return;
  std::vector<std::string> found;
  for (const table::Column& column : recorded.table.columns) found.push_back(title(column));
  throw yaml::Error(yaml::Fault{{recorded.file, recorded.has_lines ? yaml::Mark{1, 1} : yaml::Mark{}},
                                "",
                                fmt::format("its columns are {}; {} records {}", fmt::join(found, ", "),
                                            plan.diagram.file, fmt::join(titles(plan, request), ", ")),
                                {}});
}

}  // namespace stepwire::replay
