#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "engine/base/csv/cell.hpp"

namespace stepwire::csv {

/// A cell for a message.
struct SeenCell {
  std::size_t line;
  std::string text;
};

/// Decimal mark of a file by its numbers.
struct DecimalVerdict {
  Decimal decimal = Decimal::point;
  /// By column: the reason why its numbers are open, with the line of a cell.
  struct Problem {
    SeenCell cell;
    std::string reason;
  };
  std::vector<std::optional<Problem>> problems;
};

/// Finds the decimal mark of a file in all its cells. A cell like 0,2 or 1.234,5 proves a comma, one like 0.2
/// or 1,234.5 a point; 1,234 and 1.234 alone prove none. The mark that more columns prove holds for the file.
/// A column that proves the other one is refused. So is a column in which a mark may part thousands or be
/// decimal, since its numbers could be wrong by a factor of 1000. Columns with texts do not count.
class DecimalSurvey {
 public:
  explicit DecimalSurvey(std::size_t columns) : columns_(columns) {}

  void add(std::size_t column, const std::string& text, std::size_t line);
  /// `comma_separated`: a comma inside a cell is in quotes, as of a spreadsheet that parts thousands by it.
  DecimalVerdict verdict(bool comma_separated) const;

 private:
  /// First cells of a column of each kind.
  struct Column {
    bool has_text = false;
    std::optional<SeenCell> comma, point, grouped_comma, grouped_point, either_comma, either_point;

    const std::optional<SeenCell>& proof_of_comma() const { return comma ? comma : grouped_comma; }
    const std::optional<SeenCell>& proof_of_point() const { return point ? point : grouped_point; }
  };

  using Proof = const std::optional<SeenCell>& (Column::*)() const;
  std::size_t count(Proof proof) const;
  /// A cell of another column that proves a mark.
  const SeenCell* proof_in_file(Proof proof) const;
  std::optional<DecimalVerdict::Problem> conflict(const Column& column, bool comma) const;
  static std::optional<DecimalVerdict::Problem> doubt(const std::optional<SeenCell>& cell);

  std::vector<Column> columns_;
};

}  // namespace stepwire::csv
