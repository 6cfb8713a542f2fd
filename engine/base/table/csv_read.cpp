#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <unordered_set>

#include "engine/base/table/csv_cell.hpp"
#include "engine/base/table/csv_numbering.hpp"
#include "engine/base/table/csv_problems.hpp"
#include "engine/base/table/csv_title.hpp"
#include "engine/base/table/record_table.hpp"
#include "engine/base/table/table_file.hpp"
#include "engine/base/text/characters.hpp"

namespace stepwire::table {
namespace {

constexpr std::size_t longest_field = 100'000;

class Csv {
 public:
  /// `tolerant`: as read_record_csv().
  Csv(const std::string& path, std::string_view text, ColumnWords& words, bool tolerant = false)
      : path_(path), at_(text.data()), end_(at_ + text.size()), words_(words), tolerant_(tolerant) {
    if (text.starts_with("\xEF\xBB\xBF")) at_ += 3;
    if (tolerant_) begin_behind_comments();
    separator_ = separator();
  }

  Table read() {
    header();
    for (skip_comments(); !only_blanks_left(); ++rows_, skip_comments()) row();
    return std::move(table_);
  }

  RecordTable read_record() {
    RecordTable record{read()};
    problems_.settle(record, filled_rows_);
    return record;
  }

  Table read_header() {
    header();
    return std::move(table_);
  }

 private:
  [[noreturn]] void fail(const std::string& message) const {
    throw TableError(fmt::format("{}:{}: {}", path_, line_, message));
  }

  [[noreturn]] void refuse_length() const {
    fail(fmt::format("a field has more than {} characters", longest_field));
  }

  bool at_line_end() const { return at_ == end_ || *at_ == '\n' || *at_ == '\r'; }

  /// Blank lines are looked at once, however many follow each other.
  bool only_blanks_left() {
    if (!next_text_ || next_text_ < at_)
      next_text_ =
          std::find_if_not(at_, end_, [](char c) { return is_csv_blank(c) || c == '\n' || c == '\r'; });
    return next_text_ == end_;
  }

  /// Lines that begin with '#'.
  void skip_comments() {
    while (tolerant_ && at_ != end_ && *at_ == '#') {
      while (!at_line_end()) ++at_;
      skip_line_end();
    }
  }

  /// Where only numbers follow, the last comment names the columns: "# time, force".
  void begin_behind_comments() {
    const char* last = nullptr;
    std::size_t last_line = line_;
    while (at_ != end_ && *at_ == '#') {
      last = at_ + 1;
      last_line = line_;
      while (!at_line_end()) ++at_;
      skip_line_end();
    }
    if (!last || at_ == end_) return;
    const char* const here = at_;
    const std::size_t line = line_;
    separator_ = separator();
    const std::vector<std::string> titles = fields();
    const bool numbers = std::ranges::all_of(titles, [](const auto& t) { return csv_number(t).has_value(); });
    at_ = numbers ? last : here;
    line_ = numbers ? last_line : line;
  }

  /// Tab, semicolon or comma: the first of these that the header has outside of quotes.
  char separator() const {
    bool quoted = false;
    std::string found;
    for (const char* c = at_; c != end_ && (quoted || (*c != '\n' && *c != '\r')); ++c) {
      if (*c == '"') quoted = !quoted;
      if (!quoted && (*c == '\t' || *c == ';' || *c == ',')) found += *c;
    }
    for (const char candidate : {'\t', ';'}) {
      if (found.find(candidate) != std::string::npos) return candidate;
    }
    return ',';
  }

  void skip_blanks() {
    while (at_ != end_ && is_csv_blank(*at_) && *at_ != separator_) ++at_;
  }

  void skip_line_end() {
    if (at_ != end_ && *at_ == '\r') ++at_;
    if (at_ != end_ && *at_ == '\n') ++at_;
    ++line_;
  }

  /// The next field without its quotes; stops at the separator or the end of the line.
  std::string field() {
    skip_blanks();
    if (at_ != end_ && *at_ == '"') return quoted_field();
    const char* const first = at_;
    while (!at_line_end() && *at_ != separator_) ++at_;
    if (static_cast<std::size_t>(at_ - first) > longest_field) refuse_length();
    return csv_trimmed({first, at_});
  }

  std::string quoted_field() {
    std::string text;
    for (++at_; at_ != end_; ++at_) {
      if (*at_ == '"' && (at_ + 1 == end_ || at_[1] != '"')) break;
      if (*at_ == '"') ++at_;
      if (text.size() >= longest_field) refuse_length();
      text += *at_;
    }
    if (at_ == end_) fail("a quote is not closed");
    ++at_;
    skip_blanks();
    if (!at_line_end() && *at_ != separator_)
      fail(fmt::format("text follows the quoted \"{}\"", shown(text)));
    return text;
  }

  /// All fields up to the end of the line.
  std::vector<std::string> fields() {
    std::vector<std::string> result{field()};
    while (!at_line_end()) {
      ++at_;
      result.push_back(field());
    }
    return result;
  }

  void header() {
    if (only_blanks_left()) throw TableError(fmt::format("{}: the file is empty", path_));
    const std::vector<std::string> titles = fields();
    if (std::all_of(titles.begin(), titles.end(), [](const auto& t) { return csv_number(t).has_value(); })) {
      fail("the first line holds numbers; it must name the columns");
    }
    std::unordered_set<std::string> names;
    for (const std::string& title : titles) {
      table_.columns.push_back(csv_column(csv_word(title)));
      const std::string& name = table_.columns.back().name;
      if (name.empty() && !tolerant_) fail(fmt::format("column {} has no name", table_.columns.size()));
      if (!name.empty() && !names.insert(name).second)
        fail(fmt::format("two columns are named '{}'", shown(name)));
      const auto words = words_.find(name);
      numberings_.push_back({words == words_.end() ? nullptr : &words->second});
    }
    skip_line_end();
  }

  void row() {
    const char* const start = at_;
    for (std::size_t i = 0; i < table_.columns.size(); ++i) {
      if (i > 0) ++at_;  // the separator
      const bool last = i + 1 == table_.columns.size();
      const auto value = numberings_[i].texts ? std::nullopt : quick_number();
      if (!value || at_line_end() != last) return row_slowly(start);
      table_.columns[i].values.push_back(*value);
    }
    skip_line_end();
    filled_rows_ = rows_ + 1;
  }

  /// Nearly every field: plain digits up to the separator.
  std::optional<double> quick_number() {
    skip_blanks();
    double value = 0.0;
    const auto [rest, error] = std::from_chars(at_, end_, value);
    if (error != std::errc{}) return std::nullopt;
    at_ = rest;
    skip_blanks();
    return at_line_end() || *at_ == separator_ ? std::optional(value) : std::nullopt;
  }

  /// Reads a row again from its start: quoted numbers, a plus sign, or the reason why it cannot be read.
  void row_slowly(const char* start) {
    at_ = start;
    if (rows_ * table_.columns.size() > max_numbers_)  // empty rows of many columns
      fail(fmt::format("{} rows of {} columns are more than a file of this size may have", rows_ + 1,
                       table_.columns.size()));
    const std::vector<std::string> texts = cells();
    filled_rows_ = std::ranges::all_of(texts, &std::string::empty) ? filled_rows_ : rows_ + 1;
    for (std::size_t i = 0; i < texts.size(); ++i) {
      const auto value = numberings_[i].texts ? numberings_[i](csv_word(texts[i])) : csv_number(texts[i]);
      if (!value) tell_problem(texts[i], table_.columns[i].name);
      table_.columns[i].values.resize(rows_);
      table_.columns[i].values.push_back(value.value_or(std::numeric_limits<double>::quiet_NaN()));
    }
    skip_line_end();
  }

  /// The fields of a row, one for each column.
  std::vector<std::string> cells() {
    std::vector<std::string> texts = fields();
    const std::size_t wanted = table_.columns.size(), count = texts.size();
    const bool fits =
        count > wanted ? is_empty_from(texts, wanted) : is_empty_from(texts, 0) || is_unnamed_from(count);
    if (count != wanted && !(tolerant_ && fits))
      fail(fmt::format("{} value{} where the header names {}", count, count == 1 ? "" : "s", wanted));
    texts.resize(wanted);
    return texts;
  }

  static bool is_empty_from(const std::vector<std::string>& texts, std::size_t first) {
    return std::all_of(texts.begin() + static_cast<std::ptrdiff_t>(first), texts.end(),
                       [](const std::string& text) { return text.empty(); });
  }

  bool is_unnamed_from(std::size_t first) const {
    return std::all_of(table_.columns.begin() + static_cast<std::ptrdiff_t>(first), table_.columns.end(),
                       [](const Column& one) { return one.name.empty(); });
  }

  void tell_problem(const std::string& text, const std::string& column) {
    const std::string problem =
        fmt::format("'{}' {} (column '{}')", shown(text), csv_number_problem(text), shown(column));
    if (!tolerant_) fail(problem);
    problems_.add(rows_, column, fmt::format("{}:{}: {}", path_, line_, problem));
  }

  /// A text as it may stand in a message, whatever the file holds.
  static std::string shown(const std::string& text) {
    constexpr std::size_t most = 40;
    return text.size() > most ? text::visible(text.substr(0, most)) + "..." : text::visible(text);
  }

  const std::string& path_;
  const char* at_;
  const char* end_;
  const char* next_text_ = nullptr;  ///< behind blanks and empty lines
  std::size_t max_numbers_ = max_unpacked(static_cast<std::size_t>(end_ - at_)) / sizeof(double);
  char separator_ = ',';
  std::size_t line_ = 1;
  std::size_t rows_ = 0;
  Table table_;
  ColumnWords& words_;
  std::vector<CsvNumbering> numberings_;  ///< of each column
  bool tolerant_;
  std::size_t filled_rows_ = 0;  ///< up to the last one with anything in it
  CsvProblems problems_;
};

}  // namespace

Table read_csv(const std::string& path) {
  ColumnWords none;
  Table table = read_csv(path, none);
  if (table.rows() == 0) throw TableError(fmt::format("{}: there are no rows below the header", path));
  return table;
}

Table read_csv(const std::string& path, ColumnWords& words) {
  const std::string text = io::read_file(path);
  return Csv(path, text, words).read();
}

RecordTable read_record_csv(const std::string& path) {
  const std::string text = io::read_file(path);
  ColumnWords none;
  RecordTable table = Csv(path, text, none, true).read_record();
  if (table.rows() == 0) throw TableError(fmt::format("{}: there are no rows below the header", path));
  return table;
}

Table read_csv_header(const std::string& path) {
  const std::string text = io::read_file(path);
  ColumnWords none;
  return Csv(path, text, none).read_header();
}

}  // namespace stepwire::table
