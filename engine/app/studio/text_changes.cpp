#include "engine/app/studio/text_changes.hpp"

#include <algorithm>

#include "engine/app/studio/fault.hpp"
#include "engine/base/text/characters.hpp"

namespace stepwire::studio {

namespace {

/// Returns the UTF-16 units of a UTF-8 character; those of four bytes take two units.
std::size_t units_of(std::size_t bytes) {
  return bytes == 4 ? 2 : 1;
}

/// Forward cursor from UTF-16 places to bytes.
class Walk {
 public:
  explicit Walk(std::string_view text) : text_(text) {}

  /// Returns the byte offset of a place, which must not be before the previous one.
  std::size_t byte_at(std::size_t place) {
    while (units_ < place && byte_ < text_.size()) {
      const std::size_t length = std::max<std::size_t>(1, text::utf8_length(text_.substr(byte_)));
      byte_ += length;
      units_ += units_of(length);
    }
    if (units_ != place) throw Fault("a change lies outside of the text or inside of a character");
    return byte_;
  }

 private:
  std::string_view text_;
  std::size_t byte_ = 0, units_ = 0;
};

}  // namespace

std::size_t utf16_length(std::string_view text) {
  std::size_t units = 0;
  while (!text.empty()) {
    const std::size_t length = std::max<std::size_t>(1, text::utf8_length(text));
    text.remove_prefix(length);
    units += units_of(length);
  }
  return units;
}

std::string changed(std::string_view text, std::vector<TextChange> changes) {
  std::ranges::stable_sort(changes, {}, &TextChange::from);
  Walk walk(text);
  std::string result;
  std::size_t done = 0, last = 0;
  for (const TextChange& change : changes) {
    if (change.from < last || change.to < change.from) throw Fault("two changes overlap");
    last = change.to;
    const std::size_t from = walk.byte_at(change.from), to = walk.byte_at(change.to);
    result.append(text, done, from - done).append(change.text);
    done = to;
  }
  return result.append(text, done);
}

bool is_utf8(std::string_view text) {
  while (!text.empty()) {
    const std::size_t length = text::utf8_length(text);
    if (length == 0) return false;
    text.remove_prefix(length);
  }
  return true;
}

}  // namespace stepwire::studio
