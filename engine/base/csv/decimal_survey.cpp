#include "engine/base/csv/decimal_survey.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "engine/base/csv/time_stamp.hpp"
#include "engine/base/table/csv_cell.hpp"
#include "engine/base/table/csv_lines.hpp"

namespace stepwire::csv {
namespace {

/// Returns the digits of a cell such as 1,234 without its mark.
std::string without_mark(std::string text) {
  std::erase_if(text, [](char c) { return c == ',' || c == '.'; });
  return text;
}

}  // namespace

void DecimalSurvey::add(std::size_t column, const std::string& text, std::size_t line) {
  Column& at = columns_[column];
  const auto note = [&](std::optional<SeenCell>& seen) {
    if (!seen) seen = SeenCell{line, text};
  };
  switch (shape_of(text)) {
    case Shape::other:
      at.has_text = at.has_text || !(is_missing(text) || table::csv_number(text) || time_stamp(text));
      return;
    case Shape::plain:
      return;
    case Shape::comma:
      return note(at.comma);
    case Shape::point:
      return note(at.point);
    case Shape::grouped_comma:
      return note(at.grouped_comma);
    case Shape::grouped_point:
      return note(at.grouped_point);
    case Shape::either_comma:
      return note(at.either_comma);
    case Shape::either_point:
      return note(at.either_point);
  }
}

std::size_t DecimalSurvey::count(Proof proof) const {
  return static_cast<std::size_t>(std::ranges::count_if(
      columns_, [&](const Column& one) { return !one.has_text && (one.*proof)().has_value(); }));
}

const SeenCell* DecimalSurvey::proof_in_file(Proof proof) const {
  for (const Column& column : columns_)
    if (!column.has_text && (column.*proof)()) return &*(column.*proof)();
  return nullptr;
}

/// Returns the problem of a column whose decimal mark differs from that of the file, or that has both marks.
std::optional<DecimalVerdict::Problem> DecimalSurvey::conflict(const Column& column, bool comma) const {
  const auto& cell = comma ? column.proof_of_point() : column.proof_of_comma();
  const SeenCell* const other = proof_in_file(comma ? &Column::proof_of_comma : &Column::proof_of_point);
  if (!cell || !other) return std::nullopt;
  const char *const comma_name = "a decimal comma", *const point_name = "a decimal point";
  return DecimalVerdict::Problem{
      *cell, fmt::format("'{}' has {}, but '{}' in line {} has {}; write one of them in the whole file",
                         table::csv_shown(cell->text), comma ? point_name : comma_name,
                         table::csv_shown(other->text), other->line, comma ? comma_name : point_name)};
}

std::optional<DecimalVerdict::Problem> DecimalSurvey::doubt(const std::optional<SeenCell>& cell) {
  if (!cell) return std::nullopt;
  const bool comma = cell->text.find(',') != std::string::npos;
  std::string small = cell->text;
  std::ranges::replace(small, ',', '.');
  return DecimalVerdict::Problem{
      *cell, fmt::format("'{}' is {} or {}: write `decimal: \"{}\"` where the {} is decimal, or `decimal: "
                         "\"{}\"` where it parts thousands",
                         table::csv_shown(cell->text), table::csv_shown(small),
                         table::csv_shown(without_mark(cell->text)), comma ? ',' : '.',
                         comma ? "comma" : "point", comma ? '.' : ',')};
}

DecimalVerdict DecimalSurvey::verdict(bool comma_separated) const {
  const std::size_t commas = count(&Column::proof_of_comma), points = count(&Column::proof_of_point);
  const bool no_comma = std::ranges::none_of(
      columns_, [](const Column& one) { return !one.has_text && one.either_comma.has_value(); });
  const bool comma = commas > points;
  const bool certain = commas != points || (commas == 0 && comma_separated && no_comma);
  DecimalVerdict verdict;
  verdict.decimal = comma ? Decimal::comma : Decimal::point;
  for (const Column& one : columns_) {
    std::optional<DecimalVerdict::Problem> problem = conflict(one, comma);
    if (!problem && commas == points) problem = conflict(one, !comma);
    const bool grouped =
        comma ? one.proof_of_comma().has_value() : one.proof_of_point().has_value() || comma_separated;
    if (!problem && !grouped) problem = doubt(comma ? one.either_point : one.either_comma);
    if (!problem && !certain) problem = doubt(one.either_comma ? one.either_comma : one.either_point);
    if (one.has_text) problem.reset();
    verdict.problems.push_back(std::move(problem));
  }
  return verdict;
}

}  // namespace stepwire::csv
