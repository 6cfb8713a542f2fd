#include "engine/table/mat_check.hpp"

#include <fmt/format.h>

#include <array>
#include <cstdint>
#include <cstring>
#include <string_view>

#include "engine/table/file.hpp"

namespace stepwire {
namespace {

constexpr std::size_t header_size = 128;
constexpr std::uint32_t compressed = 15;

std::uint32_t swapped(std::uint32_t x) {
  return x >> 24 | (x >> 8 & 0xFF00) | (x << 8 & 0xFF0000) | x << 24;
}

}  // namespace

void check_mat_layout(const std::string& path) {
  const std::string content = read_file(path);
  const std::string_view file = content;
  if (file.size() < header_size) return;
  std::array<std::uint16_t, 2> version{};
  std::memcpy(version.data(), file.data() + 124, 4);
  const bool swap = version[1] == 0x494D;
  if (version[0] != (swap ? 0x0001 : 0x0100) || (!swap && version[1] != 0x4D49)) return;
  std::size_t at = header_size;
  while (at + 8 <= file.size()) {
    std::array<std::uint32_t, 2> tag{};
    std::memcpy(tag.data(), file.data() + at, 8);
    if (swap) tag = {swapped(tag[0]), swapped(tag[1])};
    const std::size_t padding = tag[0] == compressed ? 0 : (8 - tag[1] % 8) % 8;
    at += 8 + tag[1] + padding;
  }
  if (at != file.size()) throw TableError(fmt::format("{}: the file is damaged or cut off", path));
}

}  // namespace stepwire
