#include "engine/base/csv/read_record.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <vector>

#include "engine/base/csv/decimal_survey.hpp"
#include "engine/base/csv/encoding.hpp"
#include "engine/base/csv/time_stamp.hpp"
#include "engine/base/io/file.hpp"
#include "engine/base/table/csv_cell.hpp"
#include "engine/base/table/csv_lines.hpp"
#include "engine/base/table/table.hpp"
#include "engine/base/table/table_file.hpp"
#include "engine/base/unit/unit.hpp"

namespace stepwire::csv {
namespace {

/// True for a number with any decimal mark and for a time of the calendar.
bool is_value(const std::string& text) {
  return shape_of(text) != Shape::other || time_stamp(text).has_value();
}

/// True for a mark of a number without unit.
bool is_dash(const std::string& unit) {
  return unit == "-" || unit == "--" || unit == "\xE2\x80\x93";
}

/// True where a text in parentheses is a unit. The index of x(1) and the t of x(t) are not units.
bool is_unit_in_parentheses(const std::string& unit, bool blank_before) {
  if (unit.empty() || is_value(unit) || (unit == "t" && !blank_before)) return false;
  return is_dash(unit) || unit::parse_unit(unit).has_value();
}

/// Returns the unit of a cell in the row of units: brackets are removed, and a dash means "1".
std::string bare_unit(const std::string& cell) {
  const bool brackets = cell.size() > 2 && ((cell.front() == '[' && cell.back() == ']') ||
                                            (cell.front() == '(' && cell.back() == ')'));
  const std::string bare = brackets ? table::csv_trimmed(cell.substr(1, cell.size() - 2)) : cell;
  return is_dash(bare) ? "1" : bare;
}

/// Splits a title into name and unit: "x [mm]", or "x (mm)" where the text in parentheses is a unit.
table::Column titled_column(const std::string& title) {
  table::Column column = table::csv_column(title);
  if (is_dash(column.unit)) column.unit = "1";
  const std::size_t open = title.rfind('(');
  if (!column.unit.empty() || open == std::string::npos || open == 0 || title.back() != ')') return column;
  const std::string unit = table::csv_trimmed(title.substr(open + 1, title.size() - open - 2));
  if (!is_unit_in_parentheses(unit, table::is_csv_blank(title[open - 1]))) return column;
  return {table::csv_trimmed(title.substr(0, open)), is_dash(unit) ? "1" : unit, {}};
}

/// Returns the columns of a header; a column without a name keeps its position. Columns of the same name with
/// different units are named by their whole titles. Fails for a line of numbers only and for a duplicate
/// name.
std::vector<table::Column> columns_of(const std::vector<std::string>& titles, const table::CsvLines& lines) {
  if (std::ranges::all_of(titles,
                          [](const std::string& title) { return is_missing(title) || is_value(title); }))
    lines.fail("the first line holds numbers; it must name the columns");
  std::vector<table::Column> columns;
  std::map<std::string, int> uses;
  for (const std::string& title : titles) {
    columns.push_back(titled_column(table::csv_word(title)));
    ++uses[columns.back().name];
  }
  std::set<std::string> names;
  for (std::size_t i = 0; i < columns.size(); ++i) {
    std::string& name = columns[i].name;
    if (name.empty()) continue;
    if (uses.at(name) > 1) name = table::csv_word(titles[i]);
    if (!names.insert(name).second)
      lines.fail(fmt::format("two columns are named '{}'", table::csv_shown(name)));
  }
  return columns;
}

/// Returns the units in the row below the names, as in `s;mm;N`; std::nullopt for a row of values. A row of
/// units has no number but 1, and has units above the values of columns. If it has at least as many ones as
/// such units, one of these must be a time.
std::optional<std::vector<std::string>> units_below(const std::vector<std::string>& row,
                                                    const std::vector<std::string>& next_row) {
  std::vector<std::string> units;
  std::size_t above_values = 0, ones = 0;
  bool has_time = false;
  for (std::size_t i = 0; i < row.size(); ++i) {
    if (is_value(row[i]) && row[i] != "1") return std::nullopt;
    units.push_back(is_missing(row[i]) ? "" : bare_unit(row[i]));
    const auto unit = unit::parse_unit(units.back());
    if (row[i] == "1") ++ones;
    if (row[i] == "1" || units.back().empty() || units.back() == "1" || !unit) continue;
    if (i < next_row.size() && is_value(next_row[i])) ++above_values;
    has_time = has_time || unit->dimension == unit::Dimension{{0.0, 0.0, 1.0}};
  }
  const bool found = above_values > 0 && (has_time || ones < above_values);
  return found ? std::optional(units) : std::nullopt;
}

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
  void add(double number, std::string_view text) {
    has_numbers_ = true;
    column_.values.push_back(number);
    note_rest(text);
  }
  /// Adds any cell; `place` is "press.csv:17" for messages. A missing or unreadable value is NaN.
  void add(const std::string& text, const std::string& place);
  std::size_t rows() const { return column_.values.size(); }
  void keep_rows(std::size_t rows);

  const std::string& problem() const { return problem_; }
  /// Returns the rests of all rows, see table::RecordTable; empty if all are 0.
  std::vector<double>& rests() { return rests_; }
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
  void note_rest(std::string_view text);

  table::Column column_;
  Decimal decimal_;
  std::string problem_;
  std::optional<TimeStamp> first_stamp_;
  std::string first_stamp_text_, first_stamp_place_;
  bool grouped_ = false, has_numbers_ = false;
  std::vector<double> rests_;
};

/// Stores the rest of the last number.
void RecordColumn::note_rest(std::string_view text) {
  const double rest = rest_of(text, column_.values.back());
  if (rest == 0.0) return;
  rests_.resize(column_.values.size());
  rests_.back() = rest;
}

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
  if (const auto cell = value ? cell_number(text, decimal_) : std::nullopt) note_rest(cell->text);
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
  if (const std::string meant = with_exponent_letter(text); !meant.empty())
    return fmt::format("is no number; write an exponent with its letter, {}", meant);
  if (looks_like_time(text) && !has_numbers_)
    return "is no number, and no time that is known; write 2026-01-31T12:00:00, 20260131T120000, "
           "31.01.2026 "
           "12:00:00 or 12:00:00";
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
  if (!rests_.empty()) rests_.resize(rows);
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

using table::TableError;

/// Reader of one text. It passes over the rows twice where the decimal mark has to be inferred first.
class RecordReader {
 public:
  RecordReader(const std::string& path, const DecodedText& text, Decimal decimal)
      : path_(path),
        lines_(path, text.text),
        has_quotes_(text.text.find('"') != std::string::npos),
        decimal_(decimal),
        max_numbers_(table::max_unpacked(text.text.size()) / sizeof(double)) {
    if (!text.encoding.empty()) notes_.push_back(text.encoding);
  }

  table::RecordTable read() {
    prepare(header());
    for (skip_comments(); !lines_.only_blanks_left(); skip_comments()) row();
    return finished();
  }

  TextColumns read_texts() {
    TextColumns result{header(), {}, {}};
    result.cells.resize(wanted_);
    std::size_t filled = 0;
    for (skip_comments(); !lines_.only_blanks_left(); skip_comments()) {
      result.lines.push_back(lines_.line());
      const std::vector<std::string> texts = cells();
      for (std::size_t i = 0; i < wanted_; ++i) result.cells[i].push_back(texts[i]);
      if (!std::ranges::all_of(texts, &std::string::empty)) filled = result.lines.size();
    }
    result.lines.resize(filled);
    for (std::vector<std::string>& column : result.cells) column.resize(filled);
    return result;
  }

 private:
  /// Reads all lines above the values, and returns the columns.
  std::vector<table::Column> header() {
    begin();
    if (lines_.only_blanks_left()) throw TableError(fmt::format("{}: the file is empty", path_));
    const std::vector<std::string> titles = lines_.fields();
    std::vector<table::Column> columns = columns_of(titles, lines_);
    wanted_ = columns.size();
    for (const table::Column& column : columns) named_.push_back(!column.name.empty());
    lines_.skip_line_end();
    skip_comments();
    take_units(columns);
    return columns;
  }

  /// Skips comments and, in a file of several columns, blank lines. A blank line of a single column is a
  /// missing value.
  void skip_comments() {
    while (lines_.at_comment() || (wanted_ > 1 && lines_.at_blank_line())) lines_.skip_line();
  }

  /// Reads the lines above the columns: "sep=;" of spreadsheets, comments, and the separator of the header.
  void begin() {
    while (lines_.at_line_end() && !lines_.at_end()) lines_.skip_line_end();
    if (lines_.at("sep=")) {
      lines_.separate_by('=');
      const std::vector<std::string> words = lines_.fields();
      if (words.size() == 2 && words.back().size() <= 1) given_separator_ = words.back() + "\t";
      lines_.skip_line_end();
    }
    begin_behind_comments();
    lines_.separate_by(separator());
  }

  /// Reads a header from the last comment where only numbers follow: "# time, force".
  void begin_behind_comments() {
    std::optional<table::CsvLines::Place> last;
    for (; lines_.at_comment() || lines_.at_blank_line(); lines_.skip_line())
      if (lines_.at_comment()) last = lines_.place();
    if (!last || lines_.at_end()) return;
    const table::CsvLines::Place here = lines_.place();
    lines_.separate_by(separator());
    const std::vector<std::string> titles = lines_.fields();
    const bool values = std::ranges::all_of(titles, is_value);
    lines_.go_to(values ? *last : here);
    if (values) lines_.skip_separator();  // skips the '#'
  }

  /// Returns the separator of the line; a blank where the next line has as many numbers separated by blanks.
  char separator() {
    if (!given_separator_.empty()) return given_separator_.front();
    const char marked = lines_.separator_of_line();
    const table::CsvLines::Place here = lines_.place();
    lines_.separate_by(marked);
    if (lines_.fields().size() > 1) return lines_.go_to(here), marked;
    lines_.go_to(here);
    if (is_parted_by_bars()) return '|';
    lines_.separate_by(' ');
    const std::size_t titles = lines_.fields().size();
    if (!lines_.at_end()) lines_.skip_line_end();
    const std::vector<std::string> below = lines_.fields();
    lines_.go_to(here);
    const bool values = std::ranges::all_of(
        below, [](const std::string& text) { return is_value(text) || !with_exponent_letter(text).empty(); });
    if (titles == 1 || below.size() == 1 || !values) return marked;
    if (below.size() != titles) refuse_blanks(below.size(), marked);
    return below.size() == titles ? ' ' : marked;
  }

  /// True where bars part this line and the next one into as many fields.
  bool is_parted_by_bars() {
    const table::CsvLines::Place here = lines_.place();
    lines_.separate_by('|');
    const std::size_t titles = lines_.fields().size();
    if (!lines_.at_end()) lines_.skip_line_end();
    const bool found = titles > 1 && lines_.fields().size() == titles;
    lines_.go_to(here);
    return found;
  }

  /// Refuses a header whose names contain blanks above values that blanks separate, unless the row below is
  /// one value, e.g. a time.
  void refuse_blanks(std::size_t values, char marked) {
    const table::CsvLines::Place here = lines_.place();
    lines_.separate_by(marked);
    const std::vector<std::string> header = lines_.fields();
    lines_.skip_line_end();
    const std::vector<std::string> row = lines_.fields();
    lines_.go_to(here);
    if (row.size() != 1 || is_value(row.front())) return;
    lines_.fail(fmt::format(
        "the header '{}' is one name, but the row below has {} values parted by blanks; part names "
        "and values by commas, semicolons or tabs, or write names without blanks",
        table::csv_shown(header.front()), values));
  }

  /// Reads the row of units if there is one.
  void take_units(std::vector<table::Column>& columns) {
    if (lines_.only_blanks_left()) return;
    const table::CsvLines::Place here = lines_.place();
    const std::vector<std::string> row = lines_.fields();
    const std::size_t line = lines_.line();
    lines_.skip_line_end();
    const table::CsvLines::Place below = lines_.place();
    skip_comments();
    const auto units =
        row.size() > wanted_ || lines_.at_end() ? std::nullopt : units_below(row, lines_.fields());
    lines_.go_to(units ? below : here);
    if (!units) return;
    notes_.push_back(fmt::format("units in line {}", line));
    for (std::size_t i = 0; i < units->size(); ++i) {
      std::string& unit = columns[i].unit;
      if (!unit.empty() && !(*units)[i].empty() && (*units)[i] != unit)
        throw TableError(
            fmt::format("{}:{}: '{}' is in {} by its name, but in {} by this row; leave one of them", path_,
                        line, table::csv_shown(columns[i].name), unit, (*units)[i]));
      if (unit.empty()) unit = (*units)[i];
    }
  }

  /// Determines the decimal mark and creates the columns.
  void prepare(std::vector<table::Column> columns) {
    const bool comma_separated = lines_.separator() == ',';
    DecimalVerdict verdict{decimal_, {}};
    if (decimal_ == Decimal::detect && comma_separated && !has_quotes_) verdict.decimal = Decimal::point;
    if (verdict.decimal == Decimal::detect) verdict = survey().verdict(comma_separated);
    verdict.problems.resize(wanted_);
    for (std::size_t i = 0; i < wanted_; ++i) {
      const auto& problem = verdict.problems[i];
      const std::string text = problem ? fmt::format("{}:{}: {} (column '{}')", path_, problem->cell.line,
                                                     problem->reason, table::csv_shown(columns[i].name))
                                       : "";
      columns_.emplace_back(std::move(columns[i]), verdict.decimal, text);
    }
    decimal_ = verdict.decimal;
  }

  DecimalSurvey survey() {
    DecimalSurvey survey(wanted_);
    const table::CsvLines::Place here = lines_.place();
    for (skip_comments(); !lines_.only_blanks_left(); skip_comments()) {
      const std::size_t line = lines_.line();
      const std::vector<std::string> texts = cells();
      for (std::size_t i = 0; i < texts.size(); ++i)
        if (named_[i]) survey.add(i, texts[i], line);
    }
    lines_.go_to(here);
    return survey;
  }

  void row() {
    note_line();
    const table::CsvLines::Place start = lines_.place();
    for (std::size_t i = 0; i < wanted_; ++i) {
      if (i > 0) lines_.skip_separator();
      const bool quick = lines_.separator() != ' ' && columns_[i].takes_quick_numbers();
      const char* const text = lines_.place().at;
      const auto value = quick ? lines_.quick_number() : std::nullopt;
      if (!value || *value != *value || lines_.at_line_end() != (i + 1 == wanted_)) {
        lines_.go_to(start);
        return row_slowly(i);
      }
      columns_[i].add(*value, {text, lines_.place().at});
    }
    lines_.skip_line_end();
    filled_rows_ = ++rows_;
  }

  /// Reads a row from the cell `taken` on; the cells before it are already stored.
  void row_slowly(std::size_t taken) {
    if (rows_ * wanted_ > max_numbers_)  // possible with empty rows of many columns
      lines_.fail(fmt::format("{} rows of {} columns are more than a file of this size may have", rows_ + 1,
                              wanted_));
    const std::string place = fmt::format("{}:{}", path_, lines_.line());
    const std::vector<std::string> texts = cells();
    ++rows_;
    if (!std::ranges::all_of(texts, &std::string::empty)) filled_rows_ = rows_;
    for (std::size_t i = taken; i < wanted_; ++i) columns_[i].add(texts[i], place);
  }

  /// Records a row whose line does not directly follow the row before, after comments or quoted line ends.
  void note_line() {
    if (row_lines_.empty() || lines_.line() != row_lines_.back().line + (rows_ - row_lines_.back().row))
      row_lines_.push_back({rows_, lines_.line()});
  }

  /// Returns the fields of a row, one a column, and moves the cursor past them.
  std::vector<std::string> cells() {
    std::vector<std::string> texts = lines_.fields();
    const std::size_t count = texts.size();
    const bool fits =
        count > wanted_ ? is_empty_from(texts, wanted_) : is_empty_from(texts, 0) || is_unnamed_from(count);
    if (count != wanted_ && !fits) refuse_count(texts);
    texts.resize(wanted_);
    lines_.skip_line_end();
    return texts;
  }

  [[noreturn]] void refuse_count(const std::vector<std::string>& texts) const {
    const std::size_t count = texts.size();
    const bool values = std::ranges::all_of(texts, is_value);
    const bool names = count > 1 && std::ranges::none_of(texts, is_value);
    const char* cure = "";
    if (values && lines_.separator() == ',' && count == 2 * wanted_)
      cure =
          "; decimal commas between commas cannot be told apart: write the file with semicolons between the "
          "columns, or with decimal points";
    else if (names)
      cure = "; if this line is the header, delete the lines above it, or begin them with '#'";
    lines_.fail(
        fmt::format("{} value{} where the header names {}{}", count, count == 1 ? "" : "s", wanted_, cure));
  }

  static bool is_empty_from(const std::vector<std::string>& texts, std::size_t first) {
    return std::all_of(texts.begin() + static_cast<std::ptrdiff_t>(first), texts.end(),
                       [](const std::string& text) { return text.empty(); });
  }

  bool is_unnamed_from(std::size_t first) const {
    return std::none_of(named_.begin() + static_cast<std::ptrdiff_t>(first), named_.end(),
                        [](bool named) { return named; });
  }

  table::RecordTable finished() {
    if (filled_rows_ == 0) throw TableError(fmt::format("{}: there are no rows below the header", path_));
    table::RecordTable table;
    note_marks();
    for (std::size_t i = 0; i < wanted_; ++i) {
      RecordColumn& column = columns_[i];
      if (!named_[i]) continue;
      column.keep_rows(filled_rows_);
      if (!column.problem().empty()) table.problems.emplace(column.name(), column.problem());
      if (!column.first_stamp().empty())
        notes_.push_back(fmt::format("'{}' in seconds from {}", column.name(), column.first_stamp()));
      if (!column.rests().empty()) table.rests.emplace(column.name(), std::move(column.rests()));
      table.columns.push_back(column.finished());
    }
    table.lines = std::move(row_lines_);
    table.notes = std::move(notes_);
    return table;
  }

  void note_marks() {
    const char separator = lines_.separator();
    std::vector<std::string> marks{separator == '\t'  ? "tabs between columns"
                                   : separator == ' ' ? "blanks between columns"
                                                      : fmt::format("separator '{}'", separator),
                                   decimal_ == Decimal::comma ? "decimal comma" : "decimal point"};
    if (std::ranges::any_of(columns_, &RecordColumn::has_groups)) marks.emplace_back("thousands separators");
    notes_.insert(notes_.begin(), marks.begin(), marks.end());
  }

  const std::string& path_;
  table::CsvLines lines_;
  bool has_quotes_;
  Decimal decimal_;
  std::size_t max_numbers_, wanted_ = 0;
  std::string given_separator_;
  std::vector<bool> named_;
  std::vector<RecordColumn> columns_;
  std::size_t rows_ = 0, filled_rows_ = 0;  ///< filled_rows_: up to the last row that is not empty
  std::vector<table::RowLine> row_lines_;
  std::vector<std::string> notes_;
};

DecodedText decoded(const std::string& path) {
  try {
    return decode(io::read_file(path));
  } catch (const TableError& error) {
    throw TableError(fmt::format("{}: {}", path, error.what()));
  }
}

}  // namespace

table::RecordTable read_record(const std::string& path, Decimal decimal) {
  const DecodedText text = decoded(path);
  return RecordReader(path, text, decimal).read();
}

TextColumns read_texts(const std::string& path) {
  const DecodedText text = decoded(path);
  return RecordReader(path, text, Decimal::point).read_texts();
}

}  // namespace stepwire::csv
