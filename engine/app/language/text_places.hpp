#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

#include "engine/base/yaml/document.hpp"
#include "engine/base/yaml/text_position.hpp"

namespace stepwire::language {

/// A place as editors count: lines from 0, and in the line the units of UTF-16 before it, of which a
/// character beyond 0xffff has two.
struct EditorPosition {
  int line = 0, character = 0;

  auto operator<=>(const EditorPosition&) const = default;
};

/// From the first character to just behind the last one.
struct EditorRange {
  EditorPosition start, end;
};

/// The same as positions in a text, in bytes.
struct TextRange {
  std::size_t from = 0, to = 0;

  bool contains(std::size_t at) const { return from <= at && at <= to; }
  std::string_view in(std::string_view text) const { return text.substr(from, to - from); }
  auto operator<=>(const TextRange&) const = default;
};

/// Places of a text in the three ways in which they are counted: bytes, characters of a Mark, and UTF-16. The
/// text must outlive it.
class TextPlaces {
 public:
  explicit TextPlaces(std::string_view text) : text_(text), lines_(text) {}

  std::string_view text() const { return text_; }
  std::size_t offset(const yaml::Mark& mark) const { return lines_.position(mark); }
  /// The end of the line where it lies behind that.
  std::size_t offset(const EditorPosition& position) const;
  EditorPosition position(std::size_t offset);
  EditorRange range(const TextRange& range) { return {position(range.from), position(range.to)}; }
  TextRange range(const yaml::Mark& from, const yaml::Mark& to) const { return {offset(from), offset(to)}; }
  TextRange range(const yaml::Node& node) const { return range(node.mark, node.end); }
  TextRange key_range(const yaml::Entry& entry) const { return range(entry.mark, entry.end); }

 private:
  std::string_view text_;
  yaml::LineIndex lines_;
};

/// Places of a text as browsers count them: units of UTF-16 from its start. The text must outlive it.
class Utf16Places {
 public:
  explicit Utf16Places(std::string_view text);

  /// Of a position in bytes, or of the end where it lies behind that.
  std::size_t units(std::size_t offset) const;
  /// The position of the last character that begins there or before, or the end.
  std::size_t offset(std::size_t units) const;

 private:
  std::string_view text_;
  std::vector<std::size_t> steps_;  ///< units before every so many bytes
};

}  // namespace stepwire::language
