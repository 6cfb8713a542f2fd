#include "engine/base/csv/read_record.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "engine/base/csv/decimal_survey.hpp"
#include "engine/base/csv/encoding.hpp"
#include "engine/base/csv/record_column.hpp"
#include "engine/base/csv/record_header.hpp"
#include "engine/base/io/file.hpp"
#include "engine/base/table/csv_lines.hpp"
#include "engine/base/table/table_file.hpp"

namespace stepwire::csv {
namespace {

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
    begin();
    if (lines_.only_blanks_left()) throw TableError(fmt::format("{}: the file is empty", path_));
    const std::vector<std::string> titles = lines_.fields();
    std::vector<table::Column> columns = columns_of(titles, lines_);
    wanted_ = columns.size();
    for (const table::Column& column : columns) named_.push_back(!column.name.empty());
    lines_.skip_line_end();
    skip_comments();
    take_units(columns);
    prepare(std::move(columns));
    for (skip_comments(); !lines_.only_blanks_left(); skip_comments()) row();
    return finished();
  }

 private:
  void skip_comments() {
    while (lines_.at_comment()) lines_.skip_line();
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
    while (lines_.at_comment()) {
      last = lines_.place();
      lines_.skip_line();
    }
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
    lines_.separate_by(' ');
    const std::size_t titles = lines_.fields().size();
    if (!lines_.at_end()) lines_.skip_line_end();
    const std::vector<std::string> below = lines_.fields();
    lines_.go_to(here);
    if (titles == 1 || below.size() == 1 || !std::ranges::all_of(below, is_value)) return marked;
    if (below.size() != titles) refuse_blanks(below.size(), marked);
    return below.size() == titles ? ' ' : marked;
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
      const auto value = quick ? lines_.quick_number() : std::nullopt;
      if (!value || *value != *value || lines_.at_line_end() != (i + 1 == wanted_)) {
        lines_.go_to(start);
        return row_slowly(i);
      }
      columns_[i].add(*value);
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

}  // namespace stepwire::csv
