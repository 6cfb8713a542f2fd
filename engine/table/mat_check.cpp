#include "engine/table/mat_check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <string_view>

#include "engine/table/file.hpp"

namespace stepwire {
namespace {

using Words = std::array<std::uint32_t, 5>;

constexpr std::size_t file_header = 128;

std::uint32_t swapped(std::uint32_t x) {
  return x >> 24 | (x >> 8 & 0xFF00) | (x << 8 & 0xFF0000) | x << 24;
}

/// Up to five 32-bit words at `at`; zeros where the file ends.
Words words_at(std::string_view file, std::size_t at, bool swap) {
  Words words{};
  std::memcpy(words.data(), file.data() + at, std::min(sizeof words, file.size() - at));
  if (swap) std::transform(words.begin(), words.end(), words.begin(), swapped);
  return words;
}

/// Version and byte order as the header of levels 5 and 7.3 has them; 0 for none.
struct Header {
  unsigned version = 0;
  bool swap = false;
};

Header header_of(std::string_view file) {
  if (file.size() < file_header) return {};
  std::array<std::uint16_t, 2> mark{};
  std::memcpy(mark.data(), file.data() + 124, 4);
  if (mark[1] == 0x4D49) return {mark[0], false};
  if (mark[1] == 0x494D) return {static_cast<unsigned>(mark[0] >> 8 | (mark[0] & 0xFF) << 8), true};
  return {};
}

/// Level 5: type and length before every piece; all but compressed ones are filled up to eight bytes.
bool fits_level_5(std::string_view file, bool swap) {
  constexpr std::uint32_t compressed = 15;
  std::size_t at = file_header;
  while (at + 8 <= file.size()) {
    const Words tag = words_at(file, at, swap);
    at += 8 + std::size_t{tag[1]} + (tag[0] == compressed ? 0 : (8 - tag[1] % 8) % 8);
  }
  return at == file.size();
}

/// Level 4: type, rows, columns, whether complex, length of the name; the name; the numbers. The digits of
/// the type are byte order, 0, number format, kind. 0 for what is no such header.
std::uint64_t length_level_4(std::string_view file, std::size_t at) {
  constexpr std::array<std::uint64_t, 6> number_sizes{8, 4, 4, 2, 2, 1};
  constexpr std::uint64_t most = 0xFFFF'FFFF;
  const bool swap = words_at(file, at, false)[0] > 4052;
  const Words words = words_at(file, at, swap);
  const auto [type, rows, columns, complex, name] = words;
  const bool known =
      type <= 4052 && type / 100 % 10 == 0 && type / 10 % 10 < number_sizes.size() && type % 10 <= 2;
  if (!known || complex > 1 || name == 0 || name > 1000 || std::uint64_t{rows} * columns > most) return 0;
  return 20 + name + std::uint64_t{rows} * columns * (1 + complex) * number_sizes[type / 10 % 10];
}

bool fits_level_4(std::string_view file) {
  std::size_t at = 0;
  while (at + 20 <= file.size()) {
    const std::uint64_t length = length_level_4(file, at);
    if (length == 0) return false;
    at += length;
  }
  return at == file.size();
}

}  // namespace

void check_mat_layout(const std::string& path) {
  const std::string file = read_file(path);
  const Header header = header_of(file);
  if (header.version == 0x0200) return;
  if (header.version == 0x0100 && !fits_level_5(file, header.swap)) {
    throw TableError(fmt::format("{}: the file is damaged or cut off", path));
  }
  if (header.version != 0x0100 && !fits_level_4(file)) {
    throw TableError(fmt::format("{}: this is no MAT file, or it is damaged", path));
  }
}

}  // namespace stepwire
