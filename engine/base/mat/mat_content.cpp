#include "engine/base/mat/mat_content.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <limits>

#include "engine/base/table/table_file.hpp"

namespace stepwire::mat {
namespace {

template <class T>
std::vector<double> numbers_of(std::string_view bytes, bool swap) {
  std::vector<double> numbers(bytes.size() / sizeof(T));
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    char raw[sizeof(T)];
    std::memcpy(raw, bytes.data() + i * sizeof(T), sizeof(T));
    if (swap) std::reverse(raw, raw + sizeof(T));
    T number;
    std::memcpy(&number, raw, sizeof(T));
    numbers[i] = static_cast<double>(number);
  }
  return numbers;
}

}  // namespace

std::size_t mat_number_size(MatNumber kind) {
  switch (kind) {
    case MatNumber::int8:
    case MatNumber::uint8:
      return 1;
    case MatNumber::int16:
    case MatNumber::uint16:
      return 2;
    case MatNumber::int32:
    case MatNumber::uint32:
    case MatNumber::float32:
      return 4;
    case MatNumber::float64:
    case MatNumber::int64:
    case MatNumber::uint64:
      return 8;
  }
  return 0;
}

std::vector<double> mat_numbers(std::string_view bytes, MatNumber kind, bool swap) {
  switch (kind) {
    case MatNumber::int8:
      return numbers_of<std::int8_t>(bytes, swap);
    case MatNumber::uint8:
      return numbers_of<std::uint8_t>(bytes, swap);
    case MatNumber::int16:
      return numbers_of<std::int16_t>(bytes, swap);
    case MatNumber::uint16:
      return numbers_of<std::uint16_t>(bytes, swap);
    case MatNumber::int32:
      return numbers_of<std::int32_t>(bytes, swap);
    case MatNumber::uint32:
      return numbers_of<std::uint32_t>(bytes, swap);
    case MatNumber::float32:
      return numbers_of<float>(bytes, swap);
    case MatNumber::float64:
      return numbers_of<double>(bytes, swap);
    case MatNumber::int64:
      return numbers_of<std::int64_t>(bytes, swap);
    case MatNumber::uint64:
      return numbers_of<std::uint64_t>(bytes, swap);
  }
  return {};
}

std::size_t mat_count(const std::vector<std::size_t>& size) {
  constexpr std::size_t most = std::numeric_limits<std::size_t>::max() / 16;  // complex doubles have 16 bytes
  std::size_t count = 1;
  for (const std::size_t one : size) {
    if (one != 0 && count > most / one) throw table::TableError("the dimensions are beyond any memory");
    count *= one;
  }
  return count;
}

std::string mat_element(const std::string& path, std::size_t index, std::size_t count) {
  return count == 1 ? path : fmt::format("{}({})", path, index + 1);
}

}  // namespace stepwire::mat
