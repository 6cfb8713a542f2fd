#include "engine/app/difference/canonical.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

#include "engine/app/language/diagram_files.hpp"
#include "engine/app/language/written_names.hpp"

namespace stepwire::difference {
namespace {

// Marks around a name; a file that is read has no such characters in a name.
constexpr char name_begin = '\x01', name_end = '\x02';
constexpr std::string_view kind_letters = "bpio";

std::map<std::string, const yaml::Entry*, std::less<>> entries_of(const yaml::Document& document,
                                                                  const char* section) {
  std::map<std::string, const yaml::Entry*, std::less<>> found;
  if (const yaml::Node* map = document.root.find(section))
    for (const yaml::Entry& entry : map->entries) found[entry.key] = &entry;
  return found;
}

std::string_view first_of(std::string_view name) {
  return name.substr(0, name.find('.'));
}

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

/// Appends a piece without names, with numbers in SI and without blanks that mean nothing.
class PlainPiece {
 public:
  PlainPiece(std::string_view text, const TextReading& reading) : text_(text), reading_(reading) {}

  void append_to(std::string& result) {
    while (at_ < text_.size()) {
      if (text_[at_] == ' ')
        blank(result);
      else if (is_digit(text_[at_]) ||
               (text_[at_] == '.' && at_ + 1 < text_.size() && is_digit(text_[at_ + 1])))
        number(result);
      else
        result += text_[at_++];
    }
  }

 private:
  /// Keeps a blank between words.
  void blank(std::string& result) {
    while (at_ < text_.size() && text_[at_] == ' ') ++at_;
    const bool behind_word =
        !result.empty() && (language::is_name_character(result.back()) || result.back() == name_end);
    const bool before_word = at_ == text_.size() || language::is_name_character(text_[at_]);
    if (behind_word && before_word) result += ' ';
  }

  void number(std::string& result) {
    double value = 0.0;
    const auto read = std::from_chars(text_.data() + at_, text_.data() + text_.size(), value);
    std::size_t end = static_cast<std::size_t>(read.ptr - text_.data());
    if (end == at_) return void(result += text_[at_++]);
    std::size_t unit = end;
    while (unit < text_.size() && text_[unit] == ' ') ++unit;
    if (const std::size_t length = unit::unit_prefix(text_.substr(unit))) end = unit + length;
    const auto quantity = unit::parse_quantity(text_.substr(at_, end - at_));
    result +=
        quantity ? canonical_number(*quantity, std::nullopt) : std::string(text_.substr(at_, end - at_));
    at_ = end;
  }

  std::string_view text_;
  const TextReading& reading_;
  std::size_t at_ = 0;
};

std::string name_of(const language::NameInText& found, std::string_view text, const TextReading& reading) {
  const std::string_view name = found.range.in(text);
  if (found.parameter) return reading.names.parameter(name);
  if (reading.literal) return std::string(name);
  if (reading.formula) return reading.names.parameter(name);
  return reading.names.signal(name, reading.shorten);
}

/// Returns a formula with marked names. Outside of formulas only names after '$' are marked.
std::string formula_text(std::string_view text, const TextReading& reading) {
  std::string result;
  std::size_t at = 0;
  const auto plain = [&](std::size_t end) {
    std::string_view piece = text.substr(at, end - at);
    if (reading.literal)
      result += piece;
    else
      PlainPiece(piece, reading).append_to(result);
  };
  for (const language::NameInText& found : language::names_in_expression(text)) {
    const std::size_t from = found.range.from - (found.parameter && !reading.literal ? 1 : 0);
    plain(from);
    result += name_of(found, text, reading);
    at = found.range.to;
  }
  plain(text.size());
  return result;
}

bool has_operator(std::string_view text) {
  return text.find_first_of("+-*/^()<>=&|") != std::string_view::npos;
}

}  // namespace

FileNames::FileNames(const yaml::Document& document, OnlyOutput only_output)
    : blocks_(entries_of(document, "blocks")),
      parameters_(entries_of(document, "parameters")),
      inputs_(entries_of(document, "inputs")),
      only_output_(std::move(only_output)) {}

std::string FileNames::block(const yaml::Entry& block, std::string_view rest, bool shorten) const {
  const std::string output = shorten && !rest.empty() ? only_output_(block) : "";
  if (!output.empty() && first_of(rest.substr(1)) == output) rest.remove_prefix(1 + output.size());
  return marked(NameKind::block, block.key) + std::string(rest);
}

std::string FileNames::signal(std::string_view name, bool shorten) const {
  for (std::size_t end = name.size(); end != std::string_view::npos && end > 0;
       end = name.rfind('.', end - 1))
    if (const auto found = blocks_.find(name.substr(0, end)); found != blocks_.end())
      return block(*found->second, name.substr(end), shorten);
  const std::string_view first = first_of(name);
  if (inputs_.contains(first)) return marked(NameKind::input, first) + std::string(name.substr(first.size()));
  return parameter(name);
}

std::string FileNames::parameter(std::string_view name) const {
  const std::string_view first = first_of(name);
  if (!parameters_.contains(first)) return std::string(name);
  return marked(NameKind::parameter, first) + std::string(name.substr(first.size()));
}

std::string FileNames::any(std::string_view name) const {
  return signal(name, false);
}

std::string marked(NameKind kind, std::string_view name) {
  return fmt::format("{}{}{}{}", name_begin, kind_letters[static_cast<std::size_t>(kind)], name, name_end);
}

std::string renamed(const std::string& canonical, const NewNames& names) {
  std::string result;
  std::size_t at = 0;
  for (std::size_t begin; (begin = canonical.find(name_begin, at)) != std::string::npos;) {
    const std::size_t end = canonical.find(name_end, begin);
    const auto kind = static_cast<NameKind>(kind_letters.find(canonical[begin + 1]));
    const std::string name = canonical.substr(begin + 2, end - begin - 2);
    const auto found = names.find({kind, name});
    result += canonical.substr(at, begin - at) + marked(kind, found == names.end() ? name : found->second);
    at = end + 1;
  }
  return result + canonical.substr(at);
}

std::string unmarked(const std::string& canonical) {
  std::string result;
  for (std::size_t at = 0; at < canonical.size(); ++at) {
    if (canonical[at] == name_begin)
      ++at;
    else if (canonical[at] != name_end)
      result += canonical[at];
  }
  return result;
}

bool is_unmarked(std::string_view canonical, std::string_view name) {
  std::size_t at = 0;
  for (std::size_t i = 0; i < canonical.size(); ++i) {
    if (canonical[i] == name_begin)
      ++i;
    else if (canonical[i] != name_end && (at == name.size() || canonical[i] != name[at++]))
      return false;
  }
  return at == name.size();
}

std::vector<std::string> names_in(const std::string& canonical, NameKind kind) {
  std::vector<std::string> names;
  for (std::size_t at = 0; (at = canonical.find(name_begin, at)) != std::string::npos;) {
    const std::size_t end = canonical.find(name_end, at);
    if (canonical[at + 1] == kind_letters[static_cast<std::size_t>(kind)])
      names.push_back(canonical.substr(at + 2, end - at - 2));
    at = end;
  }
  return names;
}

std::string canonical_number(const unit::Quantity& quantity, const std::optional<unit::Dimension>& demanded) {
  const std::string number = fmt::format("{}", quantity.value == 0.0 ? 0.0 : quantity.value);
  if (!quantity.dimension || (demanded && *demanded == *quantity.dimension)) return number;
  const unit::Dimension& of = *quantity.dimension;
  return fmt::format("{}[{} {} {} {} {}]", number, fmt::join(of.exponents, ","), of.angle, of.cycles,
                     of.zeros ? fmt::format("{}", *of.zeros) : "-", of.per_difference);
}

std::string canonical_text(const std::string& text, const TextReading& reading) {
  if (reading.literal) return formula_text(text, reading);
  if (const auto quantity = unit::parse_quantity(text)) return canonical_number(*quantity, reading.demanded);
  TextReading as = reading;
  std::string_view rest = text;
  if (rest.starts_with('=')) {
    as.formula = true;
    return "=" + formula_text(rest.substr(1), as);
  }
  if (rest.starts_with('$') && names_in(formula_text(rest, as), NameKind::parameter).size() == 1 &&
      !has_operator(rest))
    return "=" + formula_text(rest, as);
  std::string unit;
  if (const std::size_t in = as.in_unit ? rest.rfind(" in ") : std::string_view::npos; in != rest.npos) {
    unit = rest.substr(in);
    rest = rest.substr(0, in);
  }
  if (!as.is_signal && as.formula && !has_operator(rest)) return text;
  return formula_text(rest, as) + unit;
}

}  // namespace stepwire::difference
