#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

#include "engine/base/table/table_file.hpp"

namespace stepwire::mcap {

// Layout: "MCAP File Format Specification", mcap.dev. A record is its kind, the length of its content [bytes]
// and the content; integers are little-endian.
inline constexpr std::string_view magic{"\x89MCAP0\r\n", 8};

enum class Kind : std::uint8_t {
  header = 0x01,
  footer = 0x02,
  schema = 0x03,
  channel = 0x04,
  message = 0x05,
  chunk = 0x06,
  message_index = 0x07,
  chunk_index = 0x08,
  statistics = 0x0B,
  summary_offset = 0x0E,
  data_end = 0x0F
};

template <class T>
void append(std::string& bytes, T number) {
  for (std::size_t i = 0; i < sizeof(T); ++i)
    bytes += static_cast<char>(static_cast<std::uint64_t>(number) >> (8 * i) & 0xFF);
}

/// Appends a text, list or map, preceded by its length in bytes.
inline void append_sized(std::string& bytes, std::string_view content) {
  append(bytes, static_cast<std::uint32_t>(content.size()));
  bytes += content;
}

inline std::string record(Kind kind, std::string_view content) {
  std::string bytes(1, static_cast<char>(kind));
  append(bytes, static_cast<std::uint64_t>(content.size()));
  return bytes.append(content);
}

/// Reader of consecutive fields. Throws TableError where the bytes end too early.
class Cursor {
 public:
  explicit Cursor(std::string_view bytes) : rest_(bytes) {}

  bool empty() const { return rest_.empty(); }
  std::string_view rest() const { return rest_; }
  std::string_view take(std::uint64_t count) {
    if (count > rest_.size()) throw table::TableError("the file is damaged or cut off");
    const std::string_view taken = rest_.substr(0, count);
    rest_.remove_prefix(count);
    return taken;
  }
  template <class T>
  T number() {
    std::uint64_t value = 0;
    const std::string_view bytes = take(sizeof(T));
    for (std::size_t i = 0; i < sizeof(T); ++i)
      value |= std::uint64_t{static_cast<unsigned char>(bytes[i])} << (8 * i);
    return static_cast<T>(value);
  }
  std::string_view text() { return take(number<std::uint32_t>()); }

 private:
  std::string_view rest_;
};

}  // namespace stepwire::mcap
