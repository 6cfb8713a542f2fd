#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "engine/base/csv/cell.hpp"

namespace stepwire::csv {

/// A cell quoted in a message.
struct SeenCell {
  std::size_t line;
  std::string text;
};

/// Inferred decimal mark of a file.
struct DecimalVerdict {
  Decimal decimal = Decimal::point;
  /// Reason why the numbers of a column are ambiguous, with the line of a cell; one entry a column.
  struct Problem {
    SeenCell cell;
    std::string reason;
  };
  std::vector<std::optional<Problem>> problems;
};

/// Infers the decimal mark of a file from all its cells. A cell such as 0,2 or 1.234,5 proves a comma; 0.2 or
/// 1,234.5 proves a point; 1,234 and 1.234 alone prove neither. The mark that more columns prove holds for
/// the file. A column that proves the other mark is refused. A column in which a mark may be decimal or
/// separate thousands is refused as well. Its numbers could be wrong by a factor of 1000. Columns with
/// texts are ignored.
class DecimalSurvey {
 public:
  explicit DecimalSurvey(std::size_t columns) : columns_(columns) {}

  void add(std::size_t column, const std::string& text, std::size_t line);
  /// Returns the verdict. `comma_separated`: a comma inside a cell is quoted, as where a spreadsheet
  /// separates thousands.
  DecimalVerdict verdict(bool comma_separated) const;

 private:
  /// First cell of each kind in a column.
  struct Column {
    bool has_text = false;
    std::optional<SeenCell> comma, point, grouped_comma, grouped_point, either_comma, either_point;

    const std::optional<SeenCell>& proof_of_comma() const { return comma ? comma : grouped_comma; }
    const std::optional<SeenCell>& proof_of_point() const { return point ? point : grouped_point; }
  };

  using Proof = const std::optional<SeenCell>& (Column::*)() const;
  std::size_t count(Proof proof) const;
  /// Returns a cell of another column that proves a mark; nullptr without one.
  const SeenCell* proof_in_file(Proof proof) const;
  std::optional<DecimalVerdict::Problem> conflict(const Column& column, bool comma) const;
  static std::optional<DecimalVerdict::Problem> doubt(const std::optional<SeenCell>& cell);

  std::vector<Column> columns_;
};

}  // namespace stepwire::csv
