#include "engine/base/mat/mat_elements.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "engine/base/table/table_file.hpp"
#include "engine/base/text/utf16.hpp"

namespace stepwire::mat {
namespace {

constexpr std::size_t tag_size = 8;

}  // namespace

std::string utf16_text(const std::vector<double>& units) {
  return text::utf8_of_utf16(std::vector<std::uint16_t>(units.begin(), units.end()));
}

MatElement MatElements::tag() const {
  if (rest_.size() < tag_size) throw table::TableError("the file is damaged or cut off");
  const std::vector<double> words = mat_numbers(rest_.substr(0, tag_size), MatNumber::uint32, swap_);
  const auto type = static_cast<std::uint32_t>(words[0]);
  if (type > 0xFFFF) return {type & 0xFFFF, type >> 16, {}};
  return {type, static_cast<std::size_t>(words[1]), {}};
}

MatElement MatElements::next() {
  MatElement element = tag();
  const auto first =
      static_cast<std::uint32_t>(mat_numbers(rest_.substr(0, 4), MatNumber::uint32, swap_).front());
  const bool small = first > 0xFFFF;
  const std::size_t begin = small ? 4 : tag_size;
  if (element.length > (small ? 4 : rest_.size() - tag_size))
    throw table::TableError("the file is damaged or cut off");
  element.bytes = rest_.substr(begin, element.length);
  const std::size_t filled = element.type == MatElement::packed ? 0 : (8 - element.length % 8) % 8;
  rest_.remove_prefix(std::min(rest_.size(), small ? tag_size : tag_size + element.length + filled));
  return element;
}

std::vector<double> MatElements::numbers(const MatElement& element) const {
  const auto kind = static_cast<MatNumber>(element.type);
  const std::size_t one = mat_number_size(kind);
  if (one == 0 || element.bytes.size() % one != 0)
    throw table::TableError(
        fmt::format("{} bytes of type {} are no numbers", element.bytes.size(), element.type));
  return mat_numbers(element.bytes, kind, swap_);
}

std::string mat_text(const MatElements& of, const MatElement& element) {
  const auto with = [&](MatNumber kind) {
    return utf16_text(of.numbers({MatElement::of(kind), element.length, element.bytes}));
  };
  if (element.type == MatElement::utf16) return with(MatNumber::uint16);
  if (element.type == MatElement::utf32) return with(MatNumber::uint32);
  const bool bytes = element.type == MatElement::utf8 || element.type == MatElement::of(MatNumber::int8) ||
                     element.type == MatElement::of(MatNumber::uint8);
  if (bytes) return std::string(element.bytes);
  if (element.type == MatElement::of(MatNumber::uint16)) return with(MatNumber::uint16);
  throw table::TableError(fmt::format("its text is of type {}, which it cannot be", element.type));
}

}  // namespace stepwire::mat
