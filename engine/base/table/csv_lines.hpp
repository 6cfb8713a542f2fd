#pragma once

#include <charconv>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/base/table/table.hpp"

namespace stepwire::table {

inline bool is_csv_blank(char c) {
  return c == ' ' || c == '\t';
}

/// Returns the text without surrounding blanks, fixed ones included.
std::string csv_trimmed(const std::string& text);

/// Splits "name [unit]" into its parts. "x[2]" without a blank is a name with an index.
Column csv_column(const std::string& title);

/// Cursor over the fields of a CSV text that tracks the line number. A separator ' ' matches a run of blanks.
class CsvLines {
 public:
  /// A position to return to.
  struct Place {
    const char* at;
    std::size_t line;
  };

  CsvLines(const std::string& path, std::string_view text)
      : path_(path), at_(text.data()), end_(at_ + text.size()) {}

  /// Throws TableError "press.csv:17: MESSAGE".
  [[noreturn]] void fail(const std::string& message) const;

  std::size_t line() const { return line_; }
  std::size_t bytes_left() const { return static_cast<std::size_t>(end_ - at_); }
  Place place() const { return {at_, line_}; }
  void go_to(Place place) {
    at_ = place.at;
    line_ = place.line;
  }

  char separator() const { return separator_; }
  void separate_by(char separator) { separator_ = separator; }
  /// Returns the first of tab, semicolon and comma that occurs in this line outside of quotes; a comma if
  /// none does.
  char separator_of_line() const;

  bool at_end() const { return at_ == end_; }
  bool at_line_end() const { return at_ == end_ || *at_ == '\n' || *at_ == '\r'; }
  /// Skips one character: the separator in front of a field.
  void skip_separator() { ++at_; }
  bool at(std::string_view text) const { return std::string_view(at_, bytes_left()).starts_with(text); }
  /// True where the line begins with '#'.
  bool at_comment() const { return at("#"); }
  /// True where only blanks, no separators, follow up to the end of the line, and more text behind it.
  bool at_blank_line() const;
  void skip_line();
  void skip_line_end();
  /// True where no more fields follow. A run of blank lines is scanned only once.
  bool only_blanks_left();

  /// Returns all fields up to the end of the line, without surrounding blanks and quotes.
  std::vector<std::string> fields();

  /// Parses the common case of a field, plain digits up to the separator. Returns std::nullopt for other
  /// fields and leaves the cursor inside of the field.
  std::optional<double> quick_number() {
    skip_blanks();
    double value = 0.0;
    const auto [rest, error] = std::from_chars(at_, end_, value);
    if (error != std::errc{}) return std::nullopt;
    at_ = rest;
    skip_blanks();
    return at_line_end() || *at_ == separator_ ? std::optional(value) : std::nullopt;
  }

 private:
  [[noreturn]] void refuse_length() const;
  void skip_blanks() {
    while (at_ != end_ && is_csv_blank(*at_) && *at_ != separator_) ++at_;
  }
  void skip_run() {
    while (separator_ == ' ' && at_ != end_ && is_csv_blank(*at_)) ++at_;
  }
  std::string field();
  std::string quoted_field();

  const std::string& path_;
  const char* at_;
  const char* end_;
  const char* blanks_from_ = nullptr;  ///< start of the last scanned run of blanks and empty lines
  const char* next_text_ = nullptr;    ///< end of that run
  char separator_ = ',';
  std::size_t line_ = 1;
};

/// Throws TableError for a header that is a row of numbers.
void require_csv_names(const std::vector<std::string>& titles, const CsvLines& lines);

/// Returns a text of the file in printable form for a message, truncated if it is long.
std::string csv_shown(const std::string& text);

}  // namespace stepwire::table
