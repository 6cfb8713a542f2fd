#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/base/csv/cell.hpp"
#include "engine/base/csv/time_stamp.hpp"
#include "engine/base/table/table.hpp"

namespace stepwire::csv {

/// A column of a record while its cells are read: numbers under one decimal mark, or times of the calendar,
/// which become seconds from the earliest one.
class RecordColumn {
 public:
  /// `wrong`: the reason why the column cannot be read, with its place; empty for a good one.
  RecordColumn(table::Column column, Decimal decimal, std::string wrong)
      : column_(std::move(column)), decimal_(decimal), problem_(std::move(wrong)) {}

  const std::string& name() const { return column_.name; }
  /// Nearly every cell: digits with a decimal point, where the column takes such numbers.
  bool takes_quick_numbers() const { return decimal_ != Decimal::comma && !first_stamp_; }
  void add(double number) {
    has_numbers_ = true;
    column_.values.push_back(number);
  }
  /// Any cell; `place` is "press.csv:17" for the message. A missing value and one that cannot be read are
  /// nan.
  void add(const std::string& text, const std::string& place);
  std::size_t rows() const { return column_.values.size(); }
  void keep_rows(std::size_t rows);

  const std::string& problem() const { return problem_; }
  bool has_groups() const { return grouped_; }
  /// The first time of the calendar as the file writes it; empty for a column of numbers.
  const std::string& first_stamp() const { return first_stamp_text_; }

  /// The column, with seconds for times.
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
