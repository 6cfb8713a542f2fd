#include "engine/base/csv/record_column.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/base/table/csv_cell.hpp"
#include "engine/base/table/csv_lines.hpp"

namespace stepwire::csv {

void RecordColumn::add(const std::string& text, const std::string& place) {
  std::optional<double> value = number_of(text);
  if (value && first_stamp_) {
    refuse(text, place, fmt::format("is no time like '{}'", first_stamp_text_));
    value = std::nullopt;
  } else if (value) {
    has_numbers_ = true;
  } else if (!is_missing(text)) {
    value = seconds_of(text, place);
  }
  column_.values.push_back(value.value_or(std::numeric_limits<double>::quiet_NaN()));
}

/// Returns the number of a cell, infinity included; the block FromFile refuses infinity later.
std::optional<double> RecordColumn::number_of(const std::string& text) {
  if (const auto cell = cell_number(text, decimal_)) {
    grouped_ = grouped_ || cell->grouped;
    return table::csv_number(cell->text);
  }
  const auto other = shape_of(text) == Shape::other ? table::csv_number(text) : std::nullopt;
  return other && std::isinf(*other) ? other : std::nullopt;
}

/// Returns the seconds of a time cell. A column holds times of one form or numbers, never both.
std::optional<double> RecordColumn::seconds_of(const std::string& text, const std::string& place) {
  const auto stamp = problem_.empty() ? time_stamp(text) : std::nullopt;
  if (!stamp || has_numbers_) {
    refuse(text, place, problem_of(text));
    return std::nullopt;
  }
  if (!first_stamp_) {
    first_stamp_ = stamp;
    first_stamp_text_ = text;
    first_stamp_place_ = place;
  }
  if (stamp->is_like(*first_stamp_)) return stamp->since(*first_stamp_);
  refuse(text, place,
         fmt::format("is not written as '{}' at {}; write all times of a column in one form, with a zone or "
                     "without",
                     first_stamp_text_, first_stamp_place_));
  return std::nullopt;
}

std::string RecordColumn::problem_of(const std::string& text) const {
  const Decimal other = decimal_ == Decimal::comma ? Decimal::point : Decimal::comma;
  if (const auto cell = cell_number(text, decimal_)) return table::csv_number_problem(cell->text);
  if (looks_like_time(text) && !has_numbers_)
    return "is no number, and no time that is known; write 2026-01-31T12:00:00, 20260131T120000 or "
           "31.01.2026 "
           "12:00:00";
  if (!cell_number(text, other)) return "is no number";
  return decimal_ == Decimal::comma ? "is no number with a decimal comma; say `decimal: \".\"`"
                                    : "is no number with a decimal point; say `decimal: \",\"`";
}

/// Records the first problem of the column; later ones are ignored.
void RecordColumn::refuse(const std::string& text, const std::string& place, const std::string& why) {
  if (problem_.empty())
    problem_ = fmt::format("{}: '{}' {} (column '{}')", place, table::csv_shown(text), why,
                           table::csv_shown(column_.name));
}

void RecordColumn::keep_rows(std::size_t rows) {
  column_.values.resize(rows);
}

table::Column RecordColumn::finished() {
  if (!first_stamp_) return std::move(column_);
  double earliest = 0.0;
  for (const double value : column_.values) earliest = std::min(earliest, std::isnan(value) ? 0.0 : value);
  if (earliest < 0.0)
    for (double& value : column_.values) value -= earliest;
  column_.unit = "s";
  return std::move(column_);
}

}  // namespace stepwire::csv
