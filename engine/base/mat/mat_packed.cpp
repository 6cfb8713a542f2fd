#include <array>
#include <cstdint>
#include <cstring>

#include "engine/base/mat/deflate.hpp"
#include "engine/base/mat/mat_elements.hpp"
#include "engine/base/mat/mat_file.hpp"

namespace stepwire::mat {
namespace {

constexpr std::size_t file_header = 128, tag_size = 8;

/// True for a header of level 5 in the byte order of this machine.
bool is_level_5(const std::string& file) {
  std::array<std::uint16_t, 2> end{};
  if (file.size() < file_header) return false;
  std::memcpy(end.data(), file.data() + file_header - sizeof end, sizeof end);
  return end[0] == 0x0100 && end[1] == 0x4D49;
}

/// An element of packed bytes, which the format does not fill up to a multiple of eight.
std::string packed_element(std::string_view element) {
  const std::string packed = zlib_packed(element);
  const std::array<std::uint32_t, 2> tag{MatElement::packed, static_cast<std::uint32_t>(packed.size())};
  std::string result(sizeof tag, '\0');
  std::memcpy(result.data(), tag.data(), sizeof tag);
  return result + packed;
}

}  // namespace

std::string packed_mat(const std::string& file) {
  if (!is_level_5(file)) return file;
  std::string result = file.substr(0, file_header);
  for (std::size_t at = file_header; at < file.size();) {
    std::uint32_t length = 0;
    std::memcpy(&length, file.data() + at + sizeof length, sizeof length);
    const std::size_t size = tag_size + (length + 7u) / 8u * 8u;
    result += packed_element(std::string_view(file).substr(at, size));
    at += size;
  }
  return result;
}

}  // namespace stepwire::mat
