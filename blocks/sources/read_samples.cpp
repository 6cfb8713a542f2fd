#include "blocks/sources/read_samples.hpp"

#include <fmt/format.h>

#include "engine/block/configure.hpp"
#include "engine/table/file.hpp"
#include "engine/unit/unit.hpp"

namespace stepwire {

namespace {

constexpr Dimension time_dimension{{0.0, 0.0, 1.0}};
constexpr double longest = 1e12,
                 shortest = 1e-12;  // [s]; far beyond, places in the record would not be numbers

Table read_file(const FromFile& asked, const Configure& is) {
  std::error_code none;
  if (!std::filesystem::exists(asked.file, none))
    is.refuse<&FromFile::file>(fmt::format("there is no file {}", asked.file.string()));
  if (!std::filesystem::is_regular_file(asked.file, none))
    is.refuse<&FromFile::file>(fmt::format("{} is no file that holds a table", asked.file.string()));
  try {
    return read_table(asked.file.string());
  } catch (const TableError& error) {
    is.refuse<&FromFile::file>(error.what());
  }
}

/// Where a number stands: "press.csv:17" for the 16th row below the header, "press.mat: element 16 of t".
std::string place_of(const FromFile& asked, const Column& column, std::size_t row) {
  if (asked.file.extension() == ".mat")
    return fmt::format("{}: element {} of {}", asked.file.string(), row + 1, column.name);
  return fmt::format("{}:{}: {}", asked.file.string(), row + 2, column.name);
}

std::string names_of(const Table& table) {
  std::string names;
  for (const Column& column : table.columns) names += (names.empty() ? "" : ", ") + column.name;
  return names;
}

template <auto parameter>
const Column& find_column(const FromFile& asked, const Configure& is, const Table& table,
                          const std::string& name, const char* cure) {
  const Column* column = table.find(name);
  if (!column)
    is.refuse<parameter>(
        fmt::format("{} has no column '{}'; it has: {}{}", asked.file.string(), name, names_of(table), cure));
  for (std::size_t row = 0; row < column->values.size(); ++row)
    if (!std::isfinite(column->values[row]))
      is.refuse<parameter>(fmt::format("{} is {}; every row must be a finite number",
                                       place_of(asked, *column, row), column->values[row]));
  return *column;
}

template <auto parameter>
Unit read_unit(const Configure& is, const std::string& text) {
  const auto unit = parse_unit(text);
  if (!unit)
    is.refuse<parameter>(fmt::format("'{}' is no unit; name the one of the column, as `unit: mm`", text));
  return *unit;
}

/// Times of all rows [s]. A column without a unit is in seconds.
Numbers times(const FromFile& asked, const Configure& is, const Table& table, std::size_t rows) {
  if (asked.sample_time > 0.0) {
    std::vector<double> even(rows);
    for (std::size_t row = 0; row < rows; ++row) even[row] = asked.sample_time * static_cast<double>(row);
    return Numbers(even);
  }
  const Column& column = find_column<&FromFile::time>(asked, is, table, std::string(asked.time),
                                                      "; name the one with the times, or give sample_time");
  const Unit unit = read_unit<&FromFile::time>(is, column.unit.empty() ? "s" : column.unit);
  if (unit.dimension != time_dimension)
    is.refuse<&FromFile::time>(
        fmt::format("column '{}' is in {}, not in a unit of time", column.name, column.unit));
  for (std::size_t row = 1; row < column.values.size(); ++row)
    if (!(column.values[row] > column.values[row - 1]))
      is.refuse<&FromFile::time>(fmt::format("{} is {}, after {} in the row before; times must increase",
                                             place_of(asked, column, row), column.values[row],
                                             column.values[row - 1]));
  std::vector<double> result;
  for (double value : column.values) result.push_back(unit.to_si(value));
  return Numbers(result);
}

/// The unit of a column: as the block says, else as the header says, else SI.
std::string unit_of(const FromFile& asked, const Column& column, std::size_t index) {
  if (asked.unit.empty()) return column.unit;
  return asked.unit.size() == 1 ? asked.unit.front() : asked.unit[index];
}

/// `rows` rows of all columns from `first` on, in SI.
Matrix values(const FromFile& asked, const Configure& is, const std::vector<const Column*>& columns,
              Index first, Index rows) {
  std::vector<Unit> units;
  for (std::size_t i = 0; i < columns.size(); ++i)
    units.push_back(read_unit<&FromFile::unit>(is, unit_of(asked, *columns[i], i)));
  std::vector<double> all;
  for (Index row = first; row < first + rows; ++row)
    for (std::size_t i = 0; i < columns.size(); ++i)
      all.push_back(units[i].to_si(columns[i]->values[static_cast<std::size_t>(row)]));
  return {static_cast<Index>(columns.size()), rows, Numbers(all)};
}

/// The output's unit is that of the columns where they all have one and the same; a vector of several has
/// none.
void tell_unit(const FromFile& asked, Configure& is, const std::vector<const Column*>& columns) {
  const std::string text = unit_of(asked, *columns.front(), 0);
  if (text.empty()) return;
  for (std::size_t i = 1; i < columns.size(); ++i)
    if (parse_unit(unit_of(asked, *columns[i], i))->dimension != parse_unit(text)->dimension) return;
  is.unit("'u", text);
}

Samples cut(const FromFile& asked, const Configure& is, const Numbers& time, Index& first) {
  const double slack = 1e-6 * (time[time.size() - 1] - time[0]) / static_cast<double>(time.size());
  const auto below = [&](double limit) {
    return std::count_if(time.begin(), time.end(), [&](double t) { return t < limit; });
  };
  first = below(asked.from - slack);
  const Index count = below(asked.to + slack) - first;
  if (count < 2)
    is.refuse<&FromFile::file>(fmt::format("{} has {} rows in use, from {} s to {} s; two or more are needed",
                                           asked.file.string(), std::max<Index>(count, 0), time[0],
                                           time[time.size() - 1]));
  Samples samples;
  samples.time = Numbers(time.data() + first, count);
  samples.interval = (samples.end() - samples.begin()) / static_cast<double>(count - 1);
  if (!(samples.interval >= shortest && samples.begin() >= -longest && samples.end() <= longest))
    is.refuse<&FromFile::time>(
        fmt::format("{}: times beyond {} s, or closer than {} s in the mean, are no record",
                    asked.file.string(), longest, shortest));
  return samples;
}

}  // namespace

Samples read_samples(const FromFile& asked, Configure& is) {
  const Table table = read_file(asked, is);
  std::vector<const Column*> columns;
  for (const std::string& name : asked.column)
    columns.push_back(&find_column<&FromFile::column>(asked, is, table, name, ""));
  const Numbers time = times(asked, is, table, columns.front()->values.size());
  for (const Column* column : columns)
    if (static_cast<Index>(column->values.size()) != time.size())
      is.refuse<&FromFile::column>(fmt::format("{}: {} has {} rows, but there are {} times",
                                               asked.file.string(), column->name, column->values.size(),
                                               time.size()));
  Index first = 0;
  Samples samples = cut(asked, is, time, first);
  samples.value = values(asked, is, columns, first, samples.rows());
  tell_unit(asked, is, columns);
  return samples;
}

}  // namespace stepwire
