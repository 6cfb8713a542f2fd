#include "engine/base/table/csv_lines.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "engine/base/table/table_file.hpp"
#include "engine/base/text/characters.hpp"

namespace stepwire::table {
namespace {

constexpr std::size_t longest_field = 100'000;

}  // namespace

std::string csv_trimmed(const std::string& text) {
  constexpr std::array<std::string_view, 4> blanks{" ", "\t", "\xC2\xA0", "\xE2\x80\xAF"};
  std::string_view rest = text;
  const auto starts = [&](std::string_view blank) { return rest.starts_with(blank); };
  const auto ends = [&](std::string_view blank) { return rest.ends_with(blank); };
  for (auto found = std::ranges::find_if(blanks, starts); found != blanks.end();
       found = std::ranges::find_if(blanks, starts))
    rest.remove_prefix(found->size());
  for (auto found = std::ranges::find_if(blanks, ends); found != blanks.end();
       found = std::ranges::find_if(blanks, ends))
    rest.remove_suffix(found->size());
  return std::string(rest);
}

Column csv_column(const std::string& title) {
  const std::size_t open = title.rfind('[');
  if (title.empty() || title.back() != ']' || open == std::string::npos || open == 0) return {title, "", {}};
  const std::string unit = title.substr(open + 1, title.size() - open - 2);
  const bool digits = !unit.empty() && unit.find_first_not_of("0123456789") == std::string::npos;
  if (digits && !is_csv_blank(title[open - 1])) return {title, "", {}};
  return {csv_trimmed(title.substr(0, open)), csv_trimmed(unit), {}};
}

void CsvLines::fail(const std::string& message) const {
  throw TableError(fmt::format("{}:{}: {}", path_, line_, message));
}

void CsvLines::refuse_length() const {
  fail(fmt::format("a field has more than {} characters", longest_field));
}

char CsvLines::separator_of_line() const {
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

bool CsvLines::at_blank_line() const {
  const char* at = at_;
  while (at != end_ && is_csv_blank(*at) && (*at != separator_ || separator_ == ' ')) ++at;
  return at != end_ && (*at == '\n' || *at == '\r');
}

void CsvLines::skip_line() {
  while (!at_line_end()) ++at_;
  skip_line_end();
}

void CsvLines::skip_line_end() {
  if (at_ != end_ && *at_ == '\r') ++at_;
  if (at_ != end_ && *at_ == '\n') ++at_;
  ++line_;
}

bool CsvLines::only_blanks_left() {
  if (!next_text_ || next_text_ < at_ || at_ < blanks_from_) {
    blanks_from_ = at_;
    next_text_ =
        std::find_if_not(at_, end_, [](char c) { return is_csv_blank(c) || c == '\n' || c == '\r'; });
  }
  return next_text_ == end_;
}

/// Reads a field up to the separator or the end of the line.
std::string CsvLines::field() {
  skip_blanks();
  if (at_ != end_ && *at_ == '"') return quoted_field();
  const char* const first = at_;
  while (!at_line_end() && *at_ != separator_ && !(separator_ == ' ' && *at_ == '\t')) ++at_;
  if (static_cast<std::size_t>(at_ - first) > longest_field) refuse_length();
  return csv_trimmed({first, at_});
}

std::string CsvLines::quoted_field() {
  std::string text;
  const std::size_t first_line = line_;
  for (++at_; at_ != end_; ++at_) {
    if (*at_ == '\n') ++line_;
    if (*at_ == '"' && (at_ + 1 == end_ || at_[1] != '"')) break;
    if (*at_ == '"') ++at_;
    if (text.size() >= longest_field) refuse_length();
    text += *at_;
  }
  if (at_ == end_) {
    line_ = first_line;
    fail("a quote is not closed");
  }
  ++at_;
  skip_blanks();
  if (!at_line_end() && *at_ != separator_)
    fail(fmt::format("text follows the quoted \"{}\"", csv_shown(text)));
  return text;
}

std::vector<std::string> CsvLines::fields() {
  skip_run();
  std::vector<std::string> result{field()};
  for (skip_run(); !at_line_end(); skip_run()) {
    if (separator_ != ' ') ++at_;
    result.push_back(field());
  }
  return result;
}

std::string csv_shown(const std::string& text) {
  constexpr std::size_t most = 40;
  return text.size() > most ? text::visible(text.substr(0, most)) + "..." : text::visible(text);
}

}  // namespace stepwire::table
