#include "engine/base/csv/encoding.hpp"

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

#include "engine/base/table/table_file.hpp"
#include "engine/base/text/characters.hpp"
#include "engine/base/text/utf16.hpp"

namespace stepwire::csv {
namespace {

std::string utf8_of_16(std::string_view bytes, bool big) {
  if (bytes.size() % 2 != 0) throw table::TableError("the file is cut off within a character of UTF-16");
  std::vector<std::uint16_t> units;
  for (std::size_t i = 0; i < bytes.size(); i += 2) {
    const auto first = static_cast<unsigned char>(bytes[i]),
               second = static_cast<unsigned char>(bytes[i + 1]);
    units.push_back(static_cast<std::uint16_t>(big ? first << 8 | second : second << 8 | first));
  }
  return text::utf8_of_utf16(units);
}

bool is_utf8(std::string_view text) {
  while (!text.empty()) {
    const std::size_t length = static_cast<unsigned char>(text.front()) < 0x80 ? 1 : text::utf8_length(text);
    if (length == 0) return false;
    text.remove_prefix(length);
  }
  return true;
}

/// Characters of the bytes 0x80 to 0x9F by the WHATWG Encoding Standard; all other bytes are Latin-1.
constexpr std::array<std::uint16_t, 32> windows_1252{
    0x20AC, 0x81,   0x201A, 0x0192, 0x201E, 0x2026, 0x2020, 0x2021, 0x02C6, 0x2030, 0x0160,
    0x2039, 0x0152, 0x8D,   0x017D, 0x8F,   0x90,   0x2018, 0x2019, 0x201C, 0x201D, 0x2022,
    0x2013, 0x2014, 0x02DC, 0x2122, 0x0161, 0x203A, 0x0153, 0x9D,   0x017E, 0x0178};

std::string utf8_of_1252(std::string_view bytes) {
  std::string text;
  for (const char c : bytes) {
    const auto byte = static_cast<unsigned char>(c);
    text::append_utf8(text, byte >= 0x80 && byte < 0xA0 ? windows_1252[byte - 0x80] : byte);
  }
  return text;
}

/// True where every other byte of the first two characters is 0: bytes 1 and 3, or bytes 0 and 2.
bool has_zeros(std::string_view bytes, std::size_t first) {
  return bytes.size() >= 4 && bytes[first] == '\0' && bytes[first + 2] == '\0' && bytes[1 - first] != '\0' &&
         bytes[3 - first] != '\0';
}

}  // namespace

DecodedText decode(std::string bytes) {
  using namespace std::string_view_literals;
  const std::string_view all = bytes;
  if (all.starts_with("\xFF\xFE\0\0"sv) || all.starts_with("\0\0\xFE\xFF"sv))
    throw table::TableError("the file is in UTF-32; save it in UTF-8");
  if (all.starts_with("\xFF\xFE")) return {utf8_of_16(all.substr(2), false), "UTF-16 (little endian)"};
  if (all.starts_with("\xFE\xFF")) return {utf8_of_16(all.substr(2), true), "UTF-16 (big endian)"};
  if (has_zeros(all, 1)) return {utf8_of_16(all, false), "UTF-16 (little endian, no byte-order mark)"};
  if (has_zeros(all, 0)) return {utf8_of_16(all, true), "UTF-16 (big endian, no byte-order mark)"};
  if (all.starts_with("\xEF\xBB\xBF")) return {std::string(all.substr(3)), "UTF-8 with a byte-order mark"};
  if (!is_utf8(all)) return {utf8_of_1252(all), "Windows-1252"};
  return {std::move(bytes), ""};
}

}  // namespace stepwire::csv
