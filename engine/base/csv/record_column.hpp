#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/base/csv/cell.hpp"
#include "engine/base/csv/time_stamp.hpp"
#include "engine/base/table/table.hpp"

namespace stepwire::csv {

/// Column of a record under construction: numbers under one decimal mark, or times of the calendar. Times
/// become seconds since the earliest one.
class RecordColumn {
 public:
  /// `wrong`: the reason why the column is unreadable, with its place; empty for a good column.
  RecordColumn(table::Column column, Decimal decimal, std::string wrong)
      : column_(std::move(column)), decimal_(decimal), problem_(std::move(wrong)) {}

  const std::string& name() const { return column_.name; }
  /// True where a cell of digits with a decimal point can be parsed directly; this is the common case.
  bool takes_quick_numbers() const { return decimal_ != Decimal::comma && !first_stamp_; }
  void add(double number) {
    has_numbers_ = true;
    column_.values.push_back(number);
  }
  /// Adds any cell; `place` is "press.csv:17" for messages. A missing or unreadable value is NaN.
  void add(const std::string& text, const std::string& place);
  std::size_t rows() const { return column_.values.size(); }
  void keep_rows(std::size_t rows);

  const std::string& problem() const { return problem_; }
  bool has_groups() const { return grouped_; }
  /// Text of the first time in the file; empty for a column of numbers.
  const std::string& first_stamp() const { return first_stamp_text_; }

  /// Returns the column, with times as seconds.
  table::Column finished();

 private:
  std::optional<double> number_of(const std::string& text);
  std::optional<double> seconds_of(const std::string& text, const std::string& place);
  void refuse(const std::string& text, const std::string& place, const std::string& why);
  std::string problem_of(const std::string& text) const;

  table::Column column_;
  Decimal decimal_;
  std::string problem_;
  std::optional<TimeStamp> first_stamp_;
  std::string first_stamp_text_, first_stamp_place_;
  bool grouped_ = false, has_numbers_ = false;
};

}  // namespace stepwire::csv
