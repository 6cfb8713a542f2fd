#include "engine/app/language/text_places.hpp"

#include <algorithm>
#include <stdexcept>

#include "engine/base/text/characters.hpp"

namespace stepwire::language {

namespace {

/// Returns the UTF-16 units of a character by its length in UTF-8.
int utf16_units(std::size_t bytes) {
  return bytes == 4 ? 2 : 1;
}

std::size_t next(std::string_view text, std::size_t at) {
  return std::max<std::size_t>(1, text::utf8_length(text.substr(at)));
}

constexpr std::size_t bytes_of_step = 256;

/// Returns the UTF-16 units of the character that begins with this byte; 0 for a continuation byte.
std::size_t units_from(char byte) {
  const auto first = static_cast<unsigned char>(byte);
  return (first & 0xc0) == 0x80 ? 0 : first >= 0xf0 ? 2 : 1;
}

/// Comparison of the trees before and after the splices.
class Comparison {
 public:
  Comparison(std::string_view text, const std::vector<Splice>& splices) : places_(text), splices_(splices) {}

  void compare(const yaml::Node& before, const yaml::Node& after) const {
    const bool same_form = before.kind == after.kind && before.quoted == after.quoted &&
                           before.items.size() == after.items.size() &&
                           before.entries.size() == after.entries.size();
    const bool same_text = before.text == after.text || touched(places_.range(before));
    if (!same_form || !same_text) refuse();
    for (std::size_t i = 0; i < before.items.size(); ++i) compare(before.items[i], after.items[i]);
    for (std::size_t i = 0; i < before.entries.size(); ++i) {
      const yaml::Entry& entry = before.entries[i];
      if (entry.key != after.entries[i].key && !touched(places_.key_range(entry))) refuse();
      compare(entry.value, after.entries[i].value);
    }
  }

 private:
  bool touched(const TextRange& range) const {
    return std::ranges::any_of(splices_, [&](const Splice& splice) {
      return range.contains(splice.range.from) && range.contains(splice.range.to);
    });
  }
  [[noreturn]] static void refuse() { throw EditRefused("this would change more of the file than the name"); }

  TextPlaces places_;
  const std::vector<Splice>& splices_;
};

}  // namespace

std::size_t TextPlaces::offset(const EditorPosition& position) const {
  std::size_t at = lines_.position({std::max(0, position.line) + 1, 1});
  for (int units = 0; units < position.character && at < text_.size();) {
    if (text_[at] == '\n' || text_.substr(at).starts_with("\r\n")) break;
    const std::size_t bytes = next(text_, at);
    units += utf16_units(bytes);
    if (units <= position.character) at += bytes;  // a position within a surrogate pair is rounded down
  }
  return at;
}

EditorPosition TextPlaces::position(std::size_t offset) {
  offset = std::min(offset, text_.size());
  const int line = lines_.mark(offset).line;
  EditorPosition position{line - 1, 0};
  for (std::size_t at = lines_.position({line, 1}); at < offset;) {
    const std::size_t bytes = next(text_, at);
    position.character += utf16_units(bytes);
    at += bytes;
  }
  return position;
}

Utf16Places::Utf16Places(std::string_view text) : text_(text) {
  std::size_t count = 0;
  for (std::size_t at = 0; at < text.size(); ++at) {
    if (at % bytes_of_step == 0) steps_.push_back(count);
    count += units_from(text[at]);
  }
  steps_.push_back(count);
}

std::size_t Utf16Places::units(std::size_t offset) const {
  if (offset >= text_.size()) return steps_.back();
  std::size_t count = steps_[offset / bytes_of_step];
  for (std::size_t at = offset - offset % bytes_of_step; at < offset; ++at) count += units_from(text_[at]);
  return count;
}

std::size_t Utf16Places::offset(std::size_t units) const {
  const auto behind = std::upper_bound(steps_.begin(), steps_.end(), units);
  const auto step = static_cast<std::size_t>(behind - steps_.begin()) - 1;
  if (behind == steps_.end()) return text_.size();
  std::size_t count = steps_[step], at = step * bytes_of_step;
  for (std::size_t end = at; end < text_.size(); ++end) {
    count += units_from(text_[end]);
    if (units_from(text_[end]) > 0) at = end;
    if (count > units) break;
  }
  return at;
}

std::string spliced(std::string_view text, std::vector<Splice> splices) {
  std::ranges::stable_sort(splices, {}, &Splice::range);
  std::string result;
  std::size_t at = 0;
  for (const Splice& splice : splices) {
    if (splice.range.from < at || splice.range.to < splice.range.from || splice.range.to > text.size())
      throw EditRefused("two changes of one place");
    result += text.substr(at, splice.range.from - at);
    result += splice.text;
    at = splice.range.to;
  }
  return result += text.substr(at);
}

std::string spliced_values(std::string_view text, const std::vector<Splice>& splices) {
  std::string result = spliced(text, splices);
  try {
    const yaml::Document before = yaml::parse_document(text, ""), after = yaml::parse_document(result, "");
    Comparison(text, splices).compare(before.root, after.root);
  } catch (const yaml::Error& error) {
    throw EditRefused(std::string("the file could not be read any more: ") + error.what());
  }
  return result;
}

}  // namespace stepwire::language
