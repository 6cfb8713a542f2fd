#include "engine/app/studio/live/frame.hpp"

#include <algorithm>
#include <bit>
#include <cstring>

namespace stepwire::live {

namespace {

static_assert(std::endian::native == std::endian::little, "frames are written as numbers lie in memory");

template <class Number>
void append(std::string& bytes, Number number) {
  char text[sizeof(Number)];
  std::memcpy(text, &number, sizeof(Number));
  bytes.append(text, sizeof(Number));
}

}  // namespace

std::string frame(const FrameHead& head, const SampleRows& rows, const SampleStore& store) {
  constexpr std::uint8_t version = 1;
  const std::size_t count = rows.ticks.size();
  std::string bytes = "SWD1";
  bytes.reserve(32 + (rows.columns.size() + 1) * count * sizeof(double));
  append(bytes, version);
  append(bytes, static_cast<std::uint8_t>(rows.extremes ? 1 : 0));
  append(bytes, head.view);
  append(bytes, head.sequence);
  append(bytes, static_cast<std::uint32_t>(count));
  append(bytes, static_cast<std::uint16_t>(rows.columns.size() + 1));
  append(bytes, std::uint16_t{0});
  append(bytes, head.run);
  append(bytes, store.time_of(std::max<std::int64_t>(store.end_tick() - 1, 0)));
  for (std::size_t i = 0; i < count; ++i) {
    const std::int64_t last = (i + 1 < count ? rows.ticks[i + 1] : rows.end) - 1;
    append(bytes, (store.time_of(rows.ticks[i]) + store.time_of(last)) / 2.0);
  }
  for (const std::vector<double>& column : rows.columns)
    bytes.append(reinterpret_cast<const char*>(column.data()), column.size() * sizeof(double));
  return bytes;
}

}  // namespace stepwire::live
