#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "engine/base/yaml/document.hpp"
#include "engine/base/yaml/text_position.hpp"

namespace stepwire::language {

/// Position in editor coordinates: line from 0, and UTF-16 units from the start of the line. A character
/// beyond U+FFFF has two units.
struct EditorPosition {
  int line = 0, character = 0;

  auto operator<=>(const EditorPosition&) const = default;
};

/// Half-open range of editor positions.
struct EditorRange {
  EditorPosition start, end;
};

/// Range of byte offsets.
struct TextRange {
  std::size_t from = 0, to = 0;

  bool contains(std::size_t at) const { return from <= at && at <= to; }
  std::string_view in(std::string_view text) const { return text.substr(from, to - from); }
  auto operator<=>(const TextRange&) const = default;
};

/// Conversion of positions in a text between bytes, characters of a Mark, and UTF-16. The text must outlive
/// the object.
class TextPlaces {
 public:
  explicit TextPlaces(std::string_view text) : text_(text), lines_(text) {}

  std::string_view text() const { return text_; }
  std::size_t offset(const yaml::Mark& mark) const { return lines_.position(mark); }
  /// Returns the byte offset of a position; positions after the end of the line are clamped.
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

/// Conversion of byte offsets to UTF-16 units from the start of the text, as browsers count. The text must
/// outlive the object.
class Utf16Places {
 public:
  explicit Utf16Places(std::string_view text);

  /// Returns the UTF-16 units of a byte offset, clamped to the end.
  std::size_t units(std::size_t offset) const;
  /// Returns the byte offset of the character that contains this unit, clamped to the end.
  std::size_t offset(std::size_t units) const;

 private:
  std::string_view text_;
  std::vector<std::size_t> steps_;  ///< units before every 256th byte
};

/// Replacement of a range of a text.
struct Splice {
  TextRange range;
  std::string text;
};

/// Refusal of a text change that is impossible or would affect other parts of the file. The reason is a
/// sentence.
class EditRefused : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Applies splices in any order. Throws EditRefused if two of them overlap.
std::string spliced(std::string_view text, std::vector<Splice> splices);

/// Applies splices of names and values to a diagram file, and parses the text before and after. Throws
/// EditRefused if other keys or scalars would change, or if the result is invalid.
std::string spliced_values(std::string_view text, const std::vector<Splice>& splices);

}  // namespace stepwire::language
