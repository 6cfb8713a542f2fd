#include "engine/app/studio/live/frame_views.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <stdexcept>

#include "engine/app/studio/live/arguments.hpp"

namespace stepwire::live {
namespace {

static_assert(std::endian::native == std::endian::little, "frames are written as numbers lie in memory");

template <class Number>
void append(std::string& bytes, Number number) {
  char text[sizeof(Number)];
  std::memcpy(text, &number, sizeof(Number));
  bytes.append(text, sizeof(Number));
}

constexpr double most_pixels = 16'384.0;
constexpr double furthest = 1e9;            // [s]
constexpr std::size_t most_columns = 1024;  // of all views of a page; more than any screen shows

WantedView read_view(const Arguments& given) {
  WantedView view;
  view.columns = given.indices("columns");
  view.follow = given.number_if_any("follow");
  view.from = std::clamp(given.number_if_any("from").value_or(0.0), -furthest, furthest);
  view.to = std::clamp(given.number_if_any("to").value_or(furthest), -furthest, furthest);
  view.pixels = static_cast<std::size_t>(std::clamp(given.number("pixels"), 1.0, most_pixels));
  return view;
}

/// Returns the ticks of a view, some of which may not be computed yet.
SampleRange range_of(const LoadedRun& run, const WantedView& view, std::vector<std::size_t> stored,
                     std::int64_t end) {
  const double step = run.plan().diagram.step;
  SampleRange range{std::move(stored), 0, end, view.pixels};
  if (view.follow) {
    range.from = end - static_cast<std::int64_t>(std::ceil(std::min(*view.follow, furthest) / step));
    return range;
  }
  range.from = static_cast<std::int64_t>(std::ceil(view.from / step - 1e-6));
  const auto last = static_cast<std::int64_t>(std::floor(view.to / step + 1e-6));
  range.to = view.to >= furthest ? end : last + 1;
  return range;
}

/// Returns a number that changes with each start, each return to an earlier tick, and each fill of past
/// samples.
std::uint32_t life_of(const LoadedRun& run) {
  return run.status().run + (run.store().revision() << 16u);
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

void FrameViews::want(int client, const json::Json& views) {
  std::map<std::uint16_t, WantedView> wanted;
  for (const json::Json& item : views.items()) {
    const Arguments given(item);
    const double number = given.number("view");
    if (number < 0.0 || number > 65'535.0) throw std::runtime_error("a view has a number from 0 to 65535");
    wanted[static_cast<std::uint16_t>(number)] = read_view(given);
  }
  std::size_t columns = wanted.size();
  for (const auto& [number, view] : wanted) columns += view.columns.size();
  if (columns > most_columns) throw std::runtime_error("a page has at most 1024 views and columns of them");
  const std::lock_guard lock(mutex_);
  std::erase_if(views_, [&](const auto& entry) {
    return entry.first.first == client && !wanted.contains(entry.first.second);
  });
  for (auto& [number, view] : wanted) {
    View& known = views_[{client, number}];
    known.wanted = std::move(view);
    known.sent.reset();
  }
}

void FrameViews::acknowledge(int client, std::uint32_t sequence) {
  const std::lock_guard lock(mutex_);
  for (auto& [key, view] : views_)
    if (key.first == client) view.waiting.erase(sequence);
}

void FrameViews::left(int client) {
  const std::lock_guard lock(mutex_);
  std::erase_if(views_, [&](const auto& entry) { return entry.first.first == client; });
}

std::vector<std::pair<FrameViews::Key, FrameViews::View>> FrameViews::due(std::uint32_t run,
                                                                          std::int64_t end) const {
  const std::lock_guard lock(mutex_);
  std::vector<std::pair<Key, View>> found;
  for (const auto& [key, view] : views_)
    if (view.waiting.size() < most_waiting && view.sent != std::pair(run, end)) found.emplace_back(key, view);
  return found;
}

void FrameViews::send(LoadedRun& run) {
  const std::uint32_t number = life_of(run);
  const std::int64_t end = run.store().end_tick();
  for (const auto& [key, view] : due(number, end)) {
    try {
      send_view(run, key, view, end);
    } catch (const std::runtime_error&) {  // a column of another run; the page will request new ones
    }
    const std::lock_guard lock(mutex_);
    if (const auto known = views_.find(key); known != views_.end()) known->second.sent = {number, end};
  }
}

void FrameViews::send_view(LoadedRun& run, const Key& key, const View& view, std::int64_t end) {
  const SampleRange range = range_of(run, view.wanted, run.stored(view.wanted.columns), end);
  const bool is_over = view.sent && view.sent->first == life_of(run) && !view.wanted.follow &&
                       range.to <= view.sent->second && view.sent->second <= end;
  if (is_over) return;
  FrameHead head{key.second, 0, run.thread().status().run};
  {
    const std::lock_guard lock(mutex_);
    const auto known = views_.find(key);
    if (known == views_.end()) return;
    head.sequence = ++sequence_;
    known->second.waiting.insert(head.sequence);
  }
  send_(key.first, frame(head, run.store().look(range), run.store()));
}

}  // namespace stepwire::live
