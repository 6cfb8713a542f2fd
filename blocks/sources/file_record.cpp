#include "blocks/sources/file_record.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "blocks/records/row_order.hpp"
#include "engine/base/text/count.hpp"
#include "engine/base/unit/unit.hpp"
#include "engine/model/block/configure.hpp"

namespace stepwire {

namespace {

constexpr double longest = 1e12,
                 shortest = 1e-12;  // [s]; beyond these limits the arithmetic of the record would overflow

/// All ordered rows of a file, and the first of these in the record.
struct CutRows {
  std::vector<std::size_t> all_rows;
  std::size_t first;
};

/// Returns the reason why a column, or the variable that contains it (as in `ts.Data`), cannot be read;
/// nullptr without one.
const std::string* problem_of(const table::RecordTable& table, std::string name) {
  while (!name.empty()) {
    if (const auto problem = table.problems.find(name); problem != table.problems.end())
      return &problem->second;
    const std::size_t mark = name.find_last_of(".(");
    name.resize(mark == std::string::npos ? 0 : mark);
  }
  return nullptr;
}

template <auto parameter>
const table::Column& find_column(const FromFile& asked, const Configure& is, const table::RecordTable& table,
                                 const std::string& name, const char* cure) {
  const table::Column* column = table.find(name);
  if (!column) column = table.find_titled(name);
  if (const std::string* problem = problem_of(table, column ? column->name : name))
    is.refuse<parameter>(*problem);
  if (!column) is.refuse<parameter>(no_column(asked.file.string(), table, name) + cure);
  for (std::size_t row = 0; row < column->values.size(); ++row)
    if (std::isinf(column->values[row]))
      is.refuse<parameter>(fmt::format("{} is {}; every row must be a finite number",
                                       place_in_file(asked.file.string(), table, column->name, row),
                                       column->values[row]));
  return *column;
}

template <auto parameter>
unit::Unit read_unit(const Configure& is, const std::string& text) {
  const auto unit = unit::parse_unit(text);
  if (!unit)
    is.refuse<parameter>(fmt::format("'{}' is no unit; name the one of the column, as `unit: mm`", text));
  return *unit;
}

/// True for ends of names that are units but also other words, such as "in" or "min".
bool is_other_word(std::string_view ending) {
  return ending == "in" || ending == "min" || ending.size() < 2;
}

/// Returns the unit at the end of a name, such as `x_mm`, if it is not SI; an empty text otherwise.
std::string unit_in_name(const std::string& name) {
  const std::string ending = name.substr(name.rfind('_') + 1);
  if (ending.size() == name.size() || is_other_word(ending)) return "";
  const auto unit = unit::parse_unit(ending);
  return unit && (unit->scale != 1.0L || unit->offset != 0.0L) ? ending : "";
}

bool is_time_word(const std::string& name) {
  return name == "Time" || name == "TIME";
}

/// Returns the name of the column with the times. It is that of the block's key, else `time`, the one beside
/// the column in its group or an outer one, or `t`.
std::string time_name(const FromFile& asked, const table::RecordTable& table) {
  const std::string name(asked.time);
  if (name != "time" || table.find(name)) return name;
  std::string group = asked.column.front();
  for (std::size_t mark = group.find_last_of("/."); mark != std::string::npos;
       mark = group.find_last_of("/.")) {
    group.resize(mark);
    for (const char between : {'/', '.'})
      if (table.find(group + between + name)) return group + between + name;
  }
  if (table.find("t")) return "t";
  const auto other = std::ranges::find_if(table.columns, is_time_word, &table::Column::name);
  return other == table.columns.end() ? name : other->name;
}

/// Returns the unit in the name of a time column if it is not seconds: `t_ms`, `ms`, or `millis` of loggers
/// on microcontrollers; an empty text otherwise.
std::string unit_of_time_in_name(const std::string& name) {
  if (name == "millis") return "ms";
  if (name == "micros") return "us";
  const auto unit = unit::parse_unit(name);
  const bool whole = name.size() > 1 && unit && unit->dimension == time_dimension && unit->scale != 1.0L;
  return whole ? name : unit_in_name(name);
}

/// Returns the column with the times; nullptr if rows are evenly spaced.
const table::Column* time_column(const FromFile& asked, const Configure& is,
                                 const table::RecordTable& table) {
  if (asked.sample_time > 0.0) return nullptr;
  const table::Column& column = find_column<&FromFile::time>(
      asked, is, table, time_name(asked, table), "; name the one with the times, or give sample_time");
  if (const std::string told = unit_of_time_in_name(column.name); column.unit.empty() && !told.empty())
    is.refuse<&FromFile::time>(
        fmt::format("in {} the header gives no unit of '{}', which would be seconds, but its name says {}; "
                    "write `{} [{}]` there",
                    asked.file.string(), column.name, told, column.name, told));
  return &column;
}

/// Rounding of the times in a file, over the mean interval of its rows.
double rounding_of(const std::vector<double>& values, const std::vector<std::size_t>& rows) {
  if (rows.size() < 2) return 0.0;
  const double first = values[rows.front()], last = values[rows.back()];
  const double interval = (last - first) / static_cast<double>(rows.size() - 1);
  return std::max(std::abs(first), std::abs(last)) * std::numeric_limits<double>::epsilon() / interval;
}

/// Row whose time is taken off the times of a file. It is that of all columns of a file, whichever rows they
/// leave out.
struct Beginning {
  std::optional<std::size_t> row;  ///< std::nullopt: times are those of the file
  bool counts = false;             ///< True if keys of the block count from it, too.
};

/// Returns the unit of a column of times, for messages.
std::string unit_of_time(const table::Column& column) {
  return column.unit.empty() ? "s" : column.unit;
}

/// Refuses times whose own rounding would move rows. Whole numbers and those of a text have none.
void refuse_lost(const FromFile& asked, const Configure& is, const table::RecordTable& table,
                 const table::Column& column, const std::vector<std::size_t>& rows) {
  constexpr double is_lost = 1e-4;
  const bool exact = table.rests.contains(column.name) || std::ranges::all_of(rows, [&](std::size_t row) {
                       return column.values[row] == std::round(column.values[row]);
                     });
  if (!exact && rounding_of(column.values, rows) > is_lost)
    is.refuse<&FromFile::time>(
        fmt::format("{}: the times from {:.17g} {} on have too few digits for rows that are this close; let "
                    "them begin at "
                    "0, or give sample_time",
                    asked.file.string(), column.values[rows.front()], unit_of_time(column)));
}

/// Returns the beginning of times such as those since 1970. Their rounding in seconds would move rows, or
/// change the values between them.
Beginning beginning_of(const FromFile& asked, const Configure& is, const table::RecordTable& table,
                       const table::Column& column, RowOrder& order) {
  constexpr double moves = 1e-6, changes = 1e-9, late = 1e6;
  if (order.rows.empty()) return {};
  const double rounding = rounding_of(column.values, order.rows);
  const auto time_of = [&](std::size_t row) { return column.values[row]; };
  std::size_t first = order.rows.front();
  for (const std::size_t row : order.left_out)
    if (time_of(row) < time_of(first)) first = row;
  if (!(rounding > changes || std::abs(time_of(first)) > late)) return {};
  if (!std::isfinite(time_of(order.rows.back()) - time_of(first))) return {};
  refuse_lost(asked, is, table, column, order.rows);
  const bool counts = rounding > moves;
  if (counts)
    order.notes.push_back(
        fmt::format("times count from the first row, {:.17g} {}", time_of(first), unit_of_time(column)));
  return {first, counts};
}

/// Times of the rows in use and of those that are left out, in the order of each list [s].
struct RowTimes {
  std::vector<double> used, left_out;
  double origin = 0.0;  ///< time of the file at which these times are 0 [s]
};

/// Function that returns the time of a row [s], and the time of the file at which it is 0 [s].
struct TimeOfRow {
  std::function<double(std::size_t)> time;
  double origin = 0.0;
};

/// Returns the time of each row by its column. A column without a unit is in seconds.
TimeOfRow time_of_row(const FromFile& asked, const Configure& is, const table::RecordTable& table,
                      const table::Column& column, RowOrder& order) {
  const unit::Unit unit = read_unit<&FromFile::time>(is, unit_of_time(column));
  if (unit.dimension != time_dimension)
    is.refuse<&FromFile::time>(
        fmt::format("column '{}' is in {}, not in a unit of time", column.name, column.unit));
  const Beginning beginning = beginning_of(asked, is, table, column, order);
  const std::vector<double>& values = column.values;
  if (!beginning.row) return {[&values, unit](std::size_t row) { return unit.to_si(values[row]); }};
  const auto known = table.rests.find(column.name);
  const std::vector<double>* const rests = known == table.rests.end() ? nullptr : &known->second;
  const auto rest = [rests](std::size_t row) { return rests && row < rests->size() ? (*rests)[row] : 0.0; };
  const auto since = [=, &values, first = *beginning.row](std::size_t row) {
    return unit.to_si((values[row] - values[first]) + (rest(row) - rest(first)));
  };
  return {since, beginning.counts ? 0.0 : unit.to_si(values[*beginning.row])};
}

/// Returns the times of rows.
RowTimes times(const FromFile& asked, const Configure& is, const table::RecordTable& table,
               const table::Column* column, RowOrder& order) {
  const auto each = [](const std::vector<std::size_t>& rows, const auto& time_of) {
    std::vector<double> result;
    result.reserve(rows.size());
    for (const std::size_t row : rows) result.push_back(time_of(row));
    return result;
  };
  const auto even = [&](std::size_t row) { return asked.sample_time * static_cast<double>(row); };
  const TimeOfRow of = column ? time_of_row(asked, is, table, *column, order) : TimeOfRow{even};
  return {each(order.rows, of.time), each(order.left_out, of.time), of.origin};
}

/// Returns the unit of a column: that of the block's key, else of the header, else SI. A name with another
/// unit is refused.
std::string unit_of(const FromFile& asked, const Configure& is, const table::Column& column,
                    std::size_t index) {
  if (!asked.unit.empty()) return asked.unit.size() == 1 ? asked.unit.front() : asked.unit[index];
  if (const std::string told = unit_in_name(column.name); column.unit.empty() && !told.empty())
    is.refuse<&FromFile::column>(fmt::format(
        "in {} the header gives no unit of '{}', which would be SI, but its name says {}; say `unit: {}`",
        asked.file.string(), column.name, told, told));
  return column.unit;
}

/// Returns a column with its unit, without rows.
RecordColumn titled_column(const FromFile& asked, const Configure& is, const table::Column& column,
                           const std::string& text, const unit::Unit& unit) {
  if (const auto header = unit::parse_unit(column.unit);
      !column.unit.empty() && header && header->dimension != unit.dimension)
    is.refuse<&FromFile::unit>(fmt::format("'{}' is not what the header of {} says of '{}', which is in {}",
                                           text, asked.file.string(), column.name, column.unit));
  RecordColumn result{column.name, std::nullopt, {}};
  if (!text.empty()) result.dimension = unit.dimension;
  return result;
}

/// Returns the part of the rows from `first` on that is in the record, in SI.
RecordColumn read_column(const FromFile& asked, const Configure& is, const Record& record,
                         const table::Column& column, std::size_t index, const CutRows& cut) {
  const std::string text = unit_of(asked, is, column, index);
  const unit::Unit unit = read_unit<&FromFile::unit>(is, text);
  RecordColumn result = titled_column(asked, is, column, text, unit);
  const std::vector<double> all = values_of_rows(column, cut.all_rows, record.hold_missing);
  for (std::size_t i = 0; i < record.file_rows.size(); ++i) {
    const double value = all[cut.first + i];
    if (std::isnan(value))
      is.refuse<&FromFile::column>(missing_value(record, column.name, record.file_rows[i]));
    result.values.push_back(unit.to_si(value));
  }
  return result;
}

/// Keeps the rows between `from` and `to`.
CutRows cut(const FromFile& asked, const Configure& is, const std::vector<double>& time,
            std::vector<std::size_t> rows, Record& record) {
  if (time.size() < 2)
    is.refuse<&FromFile::file>(fmt::format("{} has {} in use; two or more are needed", record.file,
                                           text::counted(time.size(), "row")));
  const double slack = 1e-6 * (time.back() - time.front()) / static_cast<double>(time.size());
  const auto below = [&](double limit) {
    return std::lower_bound(time.begin(), time.end(), limit - record.origin);
  };
  const auto first = below(asked.from - slack), end = below(asked.to + slack);
  if (end - first < 2)
    is.refuse<&FromFile::file>(fmt::format("{} has {} in use, from {} s to {} s; two or more are needed",
                                           record.file, text::counted(std::max<Index>(end - first, 0), "row"),
                                           time.front() + record.origin, time.back() + record.origin));
  record.time = record.file_times = std::vector<double>(first, end);
  record.file_rows = {rows.begin() + (first - time.begin()), rows.begin() + (end - time.begin())};
  if (!(record.interval() >= shortest && *first >= -longest && record.time.back() <= longest))
    is.refuse<&FromFile::time>(
        fmt::format("{}: times beyond {} s, or closer than {} s in the mean, are no record", record.file,
                    longest, shortest));
  return {std::move(rows), static_cast<std::size_t>(first - time.begin())};
}

RowOrder rows_of(const FromFile& asked, const Configure& is, const table::RecordTable& table,
                 const table::Column* time, const std::vector<const table::Column*>& columns) {
  const std::size_t rows = (time ? time : columns.front())->values.size();
  for (const table::Column* column : columns)
    if (column->values.size() != rows)
      is.refuse<&FromFile::column>(fmt::format("{}: {} has {} rows, but there are {} times",
                                               asked.file.string(), column->name, column->values.size(),
                                               rows));
  try {
    return ordered_rows(
        {asked.file.string(), table, time, columns, asked.missing == FromFile::Missing::skip, asked.sort});
  } catch (const RowsRefused& refused) {
    is.refuse<&FromFile::time>(refused.what());
  }
}

/// Adds a note on the number of held missing values.
void note_held(const Record& record, const std::vector<const table::Column*>& columns,
               std::vector<std::string>& notes) {
  if (!record.hold_missing) return;
  for (const table::Column* column : columns) {
    const auto count = std::ranges::count_if(
        record.file_rows, [&](std::size_t row) { return std::isnan(column->values[row]); });
    if (count > 0)
      notes.push_back(
          fmt::format("{} missing value{} of '{}' held", count, count == 1 ? "" : "s", column->name));
  }
}

/// Finds the rows of the part in use that are left out, and those of them before its first row.
GapsAtEnds gaps_of(const FromFile& asked, const Record& record,
                   const std::vector<const table::Column*>& columns, const RowOrder& order,
                   const std::vector<double>& times) {
  GapsAtEnds gaps;
  const double slack = 1e-6 * record.interval();
  const double begins = record.time.front() + record.origin;
  double first = record.time.front() - slack;
  for (std::size_t i = 0; i < times.size(); ++i) {
    const double time = times[i], in_file = time + record.origin;
    if (in_file < asked.from - slack || in_file > asked.to + slack) continue;
    const std::size_t row = order.left_out[i];
    const auto missing = [row](const table::Column* column) { return std::isnan(column->values[row]); };
    const std::string place =
        place_in_file(record.file, *record.table, (*std::ranges::find_if(columns, missing))->name, row);
    if (gaps.any.empty()) gaps.any = place;
    if (time < first) {
      first = time;
      gaps.late = fmt::format(
          "{} has no value at {} s, so that this record would begin at {} s and other columns of the file "
          "earlier; say `from: {} s` in all blocks of the file, or `start: {} s` in this one",
          place, in_file, begins, begins, begins);
    }
  }
  gaps.begin = record.time.front();
  return gaps;
}

}  // namespace

FileRecord read_file_record(const FromFile& asked, const Configure& is, const table::RecordTable& table) {
  std::vector<const table::Column*> columns;
  for (const std::string& name : asked.column)
    columns.push_back(&find_column<&FromFile::column>(asked, is, table, name, ""));
  const table::Column* const time = time_column(asked, is, table);
  RowOrder order = rows_of(asked, is, table, time, columns);
  Record record;
  record.file = asked.file.string();
  record.time_name = time_name(asked, table);
  record.table = &table;
  record.hold_missing = asked.missing == FromFile::Missing::hold;
  const RowTimes all = times(asked, is, table, time, order);
  record.origin = all.origin;
  const CutRows rows = cut(asked, is, all.used, order.rows, record);
  for (std::size_t i = 0; i < columns.size(); ++i)
    record.columns.push_back(read_column(asked, is, record, *columns[i], i, rows));
  note_held(record, columns, order.notes);
  GapsAtEnds gaps = gaps_of(asked, record, columns, order, all.left_out);
  return {std::move(record), std::move(order.notes), std::move(gaps)};
}

}  // namespace stepwire
