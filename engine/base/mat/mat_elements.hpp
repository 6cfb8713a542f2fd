#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "engine/base/mat/mat_content.hpp"

namespace stepwire::mat {

/// A data element of level 5: its type and its bytes.
struct MatElement {
  static constexpr std::uint32_t matrix = 14, packed = 15, utf8 = 16, utf16 = 17, utf32 = 18;
  static constexpr std::uint32_t of(MatNumber kind) { return static_cast<std::uint32_t>(kind); }

  std::uint32_t type = 0;
  std::size_t length = 0;
  std::string_view bytes{};
};

/// Reader of consecutive data elements. Each follows a tag of eight bytes and is padded to a multiple of
/// eight. Up to four bytes are inside of the tag; compressed elements are not padded. Layout: "MAT-File
/// Format", The MathWorks.
class MatElements {
 public:
  MatElements(std::string_view bytes, bool swap) : rest_(bytes), swap_(swap) {}

  bool empty() const { return rest_.empty(); }
  /// Returns type and length of the next element, without its bytes. Throws TableError at the end.
  MatElement tag() const;
  /// Returns the next element. Throws TableError if it is truncated.
  MatElement next();
  /// Returns a reader of the elements inside of an element.
  MatElements inside(const MatElement& element) const { return {element.bytes, swap_}; }
  /// Returns the numbers of an element. Throws TableError if its type is not numeric or the last number is
  /// incomplete.
  std::vector<double> numbers(const MatElement& element) const;

 private:
  std::string_view rest_;
  bool swap_;
};

/// Converts UTF-16 or UTF-32 code units to UTF-8; surrogate pairs are joined.
std::string utf16_text(const std::vector<double>& units);

/// Returns the text of a character element as UTF-8. Throws TableError as MatElements::numbers.
std::string mat_text(const MatElements& of, const MatElement& element);

}  // namespace stepwire::mat
