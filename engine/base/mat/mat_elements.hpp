#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "engine/base/mat/mat_content.hpp"

namespace stepwire::mat {

/// A data element of level 5: what kind of content, and its bytes.
struct MatElement {
  static constexpr std::uint32_t matrix = 14, packed = 15, utf8 = 16, utf16 = 17, utf32 = 18;
  static constexpr std::uint32_t of(MatNumber kind) { return static_cast<std::uint32_t>(kind); }

  std::uint32_t type = 0;
  std::size_t length = 0;
  std::string_view bytes{};
};

/// Data elements one behind the other, each with a tag of eight bytes before it and filled up to eight; of up
/// to four bytes they lie in the tag, and packed ones are not filled up. Layout: "MAT-File Format", The
/// MathWorks.
class MatElements {
 public:
  MatElements(std::string_view bytes, bool swap) : rest_(bytes), swap_(swap) {}

  bool empty() const { return rest_.empty(); }
  /// Type and length of the next one, without its bytes. Throws TableError where there is none.
  MatElement tag() const;
  /// Throws TableError where it goes beyond the end.
  MatElement next();
  /// Those that lie inside of one.
  MatElements inside(const MatElement& element) const { return {element.bytes, swap_}; }
  /// Throws TableError where its type is none of numbers or the last one is not whole.
  std::vector<double> numbers(const MatElement& element) const;

 private:
  std::string_view rest_;
  bool swap_;
};

/// UTF-8 of units of UTF-16 or UTF-32; two halves of a character beyond 16 bits are joined.
std::string utf16_text(const std::vector<double>& units);

/// The text of an element of characters, as UTF-8. Throws TableError as MatElements::numbers.
std::string mat_text(const MatElements& of, const MatElement& element);

}  // namespace stepwire::mat
