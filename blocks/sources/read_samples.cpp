// More than 300 lines with its header: a record is read, prepared and kept by one key.
#include "blocks/sources/read_samples.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>

#include "blocks/records/preparation.hpp"
#include "engine/base/data_file/recent.hpp"
#include "engine/base/data_file/table_cache.hpp"
#include "engine/base/table/table_file.hpp"
#include "engine/base/unit/unit.hpp"
#include "engine/model/block/configure.hpp"

namespace stepwire {

namespace {

constexpr double longest = 1e12,
                 shortest = 1e-12;  // [s]; far beyond, places in the record would not be numbers

std::shared_ptr<const table::RecordTable> read_file(const FromFile& asked, const Configure& is) {
  std::error_code none;
  if (!std::filesystem::exists(asked.file.view(), none))
    is.refuse<&FromFile::file>(fmt::format("there is no file {}", asked.file.string()));
  if (!std::filesystem::is_regular_file(asked.file.view(), none))
    is.refuse<&FromFile::file>(fmt::format("{} is no file that holds a table", asked.file.string()));
  try {
    return data_file::TableCache::of_process().read(asked.file.string());
  } catch (const table::TableError& error) {
    is.refuse<&FromFile::file>(error.what());
  }
}

template <auto parameter>
const table::Column& find_column(const FromFile& asked, const Configure& is, const table::RecordTable& table,
                                 const std::string& name, const char* cure) {
  const table::Column* column = table.find(name);
  if (!column) is.refuse<parameter>(no_column(asked.file.string(), table, name) + cure);
  if (const auto problem = table.problems.find(name); problem != table.problems.end())
    is.refuse<parameter>(problem->second);
  for (std::size_t row = 0; row < column->values.size(); ++row)
    if (!std::isfinite(column->values[row]))
      is.refuse<parameter>(fmt::format("{} is {}; every row must be a finite number",
                                       place_in_file(asked.file.string(), name, row), column->values[row]));
  return *column;
}

template <auto parameter>
unit::Unit read_unit(const Configure& is, const std::string& text) {
  const auto unit = unit::parse_unit(text);
  if (!unit)
    is.refuse<parameter>(fmt::format("'{}' is no unit; name the one of the column, as `unit: mm`", text));
  return *unit;
}

/// Names that end in the word of a unit and mean something else: what comes in, the least.
bool is_other_word(std::string_view ending) {
  return ending == "in" || ending == "min" || ending.size() < 2;
}

/// The unit that a name ends in, as `x_mm`, where it is another one than SI; empty where there is none.
std::string unit_in_name(const std::string& name) {
  const std::string ending = name.substr(name.rfind('_') + 1);
  if (ending.size() == name.size() || is_other_word(ending)) return "";
  const auto unit = unit::parse_unit(ending);
  return unit && (unit->scale != 1.0L || unit->offset != 0.0L) ? ending : "";
}

/// The column with the times: as the block says, else `time`, that beside the column in its group, or `t`.
std::string time_name(const FromFile& asked, const table::RecordTable& table) {
  const std::string name(asked.time);
  if (name != "time" || table.find(name)) return name;
  const std::string& column = asked.column.front();
  const std::string beside = column.substr(0, column.rfind('/') + 1) + name;
  if (table.find(beside)) return beside;
  return table.find("t") ? "t" : name;
}

/// Times of all rows [s]. A column without a unit is in seconds.
std::vector<double> times(const FromFile& asked, const Configure& is, const table::RecordTable& table,
                          std::size_t rows) {
  std::vector<double> result(rows);
  for (std::size_t row = 0; row < rows; ++row) result[row] = asked.sample_time * static_cast<double>(row);
  if (asked.sample_time > 0.0) return result;
  const table::Column& column = find_column<&FromFile::time>(
      asked, is, table, time_name(asked, table), "; name the one with the times, or give sample_time");
  if (const std::string told = unit_in_name(column.name); column.unit.empty() && !told.empty())
    is.refuse<&FromFile::time>(
        fmt::format("in {} the header gives no unit of '{}', which would be seconds, but its name says {}; "
                    "write `{} [{}]` there",
                    asked.file.string(), column.name, told, column.name, told));
  const unit::Unit unit = read_unit<&FromFile::time>(is, column.unit.empty() ? "s" : column.unit);
  if (unit.dimension != time_dimension)
    is.refuse<&FromFile::time>(
        fmt::format("column '{}' is in {}, not in a unit of time", column.name, column.unit));
  for (std::size_t row = 1; row < column.values.size(); ++row)
    if (!(column.values[row] > column.values[row - 1]))
      is.refuse<&FromFile::time>(fmt::format("{} is {}, after {} in the row before; times must increase",
                                             place_in_file(asked.file.string(), column.name, row),
                                             column.values[row], column.values[row - 1]));
  result.clear();
  for (double value : column.values) result.push_back(unit.to_si(value));
  return result;
}

/// The unit of a column: as the block says, else as the header says, else SI. A name that says another one is
/// not passed over.
std::string unit_of(const FromFile& asked, const Configure& is, const table::Column& column,
                    std::size_t index) {
  if (!asked.unit.empty()) return asked.unit.size() == 1 ? asked.unit.front() : asked.unit[index];
  if (const std::string told = unit_in_name(column.name); column.unit.empty() && !told.empty())
    is.refuse<&FromFile::column>(fmt::format(
        "in {} the header gives no unit of '{}', which would be SI, but its name says {}; say `unit: {}`",
        asked.file.string(), column.name, told, told));
  return column.unit;
}

/// Rows of a column from `first` on, in SI.
RecordColumn read_column(const FromFile& asked, const Configure& is, const table::Column& column,
                         std::size_t index, Index first, Index rows) {
  const std::string text = unit_of(asked, is, column, index);
  const unit::Unit unit = read_unit<&FromFile::unit>(is, text);
  if (const auto header = unit::parse_unit(column.unit);
      !column.unit.empty() && header && header->dimension != unit.dimension)
    is.refuse<&FromFile::unit>(fmt::format("'{}' is not what the header of {} says of '{}', which is in {}",
                                           text, asked.file.string(), column.name, column.unit));
  RecordColumn result{column.name, std::nullopt, {}};
  if (!text.empty()) result.dimension = unit.dimension;
  for (Index row = first; row < first + rows; ++row)
    result.values.push_back(unit.to_si(column.values[static_cast<std::size_t>(row)]));
  return result;
}

/// Takes the times that the block asks for as the record's rows.
void cut(const FromFile& asked, const Configure& is, const std::vector<double>& time, Record& record) {
  const double slack = 1e-6 * (time.back() - time.front()) / static_cast<double>(time.size());
  const auto below = [&](double limit) { return std::lower_bound(time.begin(), time.end(), limit); };
  const auto first = below(asked.from - slack), end = below(asked.to + slack);
  if (end - first < 2)
    is.refuse<&FromFile::file>(fmt::format("{} has {} rows in use, from {} s to {} s; two or more are needed",
                                           record.file, std::max<Index>(end - first, 0), time.front(),
                                           time.back()));
  record.first = first - time.begin();
  record.time = record.file_times = std::vector<double>(first, end);
  if (!(record.interval() >= shortest && *first >= -longest && record.time.back() <= longest))
    is.refuse<&FromFile::time>(
        fmt::format("{}: times beyond {} s, or closer than {} s in the mean, are no record", record.file,
                    longest, shortest));
}

/// What the file holds, cut to its range.
Record read_record(const FromFile& asked, const Configure& is, const table::RecordTable& table) {
  std::vector<const table::Column*> columns;
  for (const std::string& name : asked.column)
    columns.push_back(&find_column<&FromFile::column>(asked, is, table, name, ""));
  const std::vector<double> time = times(asked, is, table, columns.front()->values.size());
  Record record;
  record.file = asked.file.string();
  record.time_name = time_name(asked, table);
  record.table = &table;
  for (const table::Column* column : columns)
    if (column->values.size() != time.size())
      is.refuse<&FromFile::column>(fmt::format("{}: {} has {} rows, but there are {} times", record.file,
                                               column->name, column->values.size(), time.size()));
  cut(asked, is, time, record);
  for (std::size_t i = 0; i < columns.size(); ++i)
    record.columns.push_back(read_column(asked, is, *columns[i], i, record.first, record.rows()));
  return record;
}

/// The output's unit is that of the columns where they all have one and the same; a vector of several has
/// none.
std::optional<std::string> unit_of(const Record& record) {
  const auto& dimension = record.columns.front().dimension;
  for (const RecordColumn& column : record.columns)
    if (!column.dimension || column.dimension != dimension) return std::nullopt;
  return unit::si_name(*dimension);
}

Samples samples_of(const Record& record) {
  std::vector<double> all;
  for (std::size_t row = 0; row < record.time.size(); ++row)
    for (const RecordColumn& column : record.columns) all.push_back(column.values[row]);
  return {Numbers(record.time),
          Matrix(static_cast<Index>(record.columns.size()), record.rows(), Numbers(all)), record.interval()};
}

/// A Fourier transform takes rows for evenly spaced.
void require_even(const FromFile& asked, const Configure& is, const Record& record) {
  if (const auto row = first_uneven(record.time))
    is.refuse<&FromFile::interpolation>(
        fmt::format("band_limited needs evenly spaced rows, but in {} the row at {} s does not fit the mean "
                    "interval of {} s; "
                    "use linear, or prepare: [{{resample: {:.6g} s}}]",
                    asked.file.string(), record.time[static_cast<std::size_t>(*row)], record.interval(),
                    record.interval()));
}

PlayedRecord played(const FromFile& asked, const Configure& is,
                    const std::shared_ptr<const table::RecordTable>& table) {
  Record record = read_record(asked, is, *table);
  prepare_record(record, asked.prepare_.value(), [&](const std::string& message, const Value& where) {
    is.refuse<&FromFile::prepare_>(message, where);
  });
  PlayedRecord result{table, samples_of(record), {}, unit_of(record)};
  if (asked.interpolation == FromFile::Interpolation::band_limited) {
    require_even(asked, is, record);
    result.smooth = BandLimited::through(result.samples.value);
  }
  return result;
}

/// A text that no other request has: of each piece, how long it is stands before it.
class Name {
 public:
  explicit Name(const FromFile& asked) {
    add(asked.file.string());
    add(asked.column);
    add(asked.unit);
    add(std::string(asked.time));
    for (const double number : {asked.sample_time, asked.from, asked.to}) add(number);
    add(asked.interpolation == FromFile::Interpolation::band_limited ? 1.0 : 0.0);
    add(asked.prepare_.value());
  }

  const std::string& text() const { return text_; }

 private:
  void add(const std::string& piece) { text_ += fmt::format("{}:{}", piece.size(), piece); }
  void add(const std::vector<std::string>& pieces) {
    text_ += fmt::format("[{}]", pieces.size());
    for (const std::string& piece : pieces) add(piece);
  }
  void add(double number) { text_ += fmt::format("{} ", number); }
  void add(const Eigen::VectorXd& numbers) { add(Eigen::MatrixXd(numbers)); }
  void add(const Eigen::MatrixXd& numbers) {
    text_ += fmt::format("[{} {}]", numbers.rows(), numbers.cols());
    for (const double number : numbers.reshaped()) add(number);
  }
  void add(const Value::List& list) {
    text_ += fmt::format("[{}]", list.size());
    for (const Value& item : list) add(item);
  }
  void add(const Value::Map& map) {
    text_ += fmt::format("{{{}}}", map.size());
    for (const ValueEntry& entry : map) {
      add(entry.key);
      add(entry.value);
    }
  }
  void add(const Value& tree) {
    text_ += static_cast<char>('a' + tree.content.index());
    std::visit([this](const auto& content) { add(content); }, tree.content);
  }

  std::string text_;
};

data_file::Recent<PlayedRecord>& records_of_process() {
  static data_file::Recent<PlayedRecord> records(8'000'000);
  return records;
}

}  // namespace

std::shared_ptr<const PlayedRecord> read_samples(const FromFile& asked, Configure& is) {
  const std::shared_ptr<const table::RecordTable> table = read_file(asked, is);
  const std::string name = Name(asked).text();
  auto record =
      records_of_process().find(name, [&](const PlayedRecord& known) { return known.table.lock() == table; });
  if (!record) {
    record = std::make_shared<const PlayedRecord>(played(asked, is, table));
    const Index numbers = record->samples.time.size() + record->samples.value.elements().size() +
                          record->smooth.fine.elements().size();
    records_of_process().keep(name, record, static_cast<std::size_t>(numbers));
  }
  if (record->unit) is.unit("'u", *record->unit);
  return record;
}

}  // namespace stepwire
