#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "engine/app/studio/live/loaded_run.hpp"
#include "engine/app/studio/live/sample_store.hpp"
#include "engine/base/json/json.hpp"

namespace stepwire::live {

/// Header fields of a data frame.
struct FrameHead {
  std::uint16_t view = 0;
  std::uint32_t sequence = 0;
  std::uint32_t run = 0;
};

/// Returns a data frame: a header of 32 bytes, then columns of little-endian doubles, the time first. The
/// time of a row of extremes is the middle of its ticks.
std::string frame(const FrameHead& head, const SampleRows& rows, const SampleStore& store);

/// Window of a view of a page: a fixed range of time, or the newest `follow` seconds.
struct WantedView {
  std::vector<std::size_t> columns;
  double from = 0.0, to = 0.0;   ///< [s]
  std::optional<double> follow;  ///< [s]
  std::size_t pixels = 1;
};

/// Views of all pages, with what each has received. The run never waits for a page: a view gets its newest
/// window when all but one of its earlier frames are acknowledged. Thread-safe.
class FrameViews {
 public:
  using Send = std::function<void(int client, std::string bytes)>;

  explicit FrameViews(Send send) : send_(std::move(send)) {}

  /// Replaces all views of a page by these, in the format of the protocol. Throws std::runtime_error.
  void want(int client, const json::Json& views);
  void acknowledge(int client, std::uint32_t sequence);
  void left(int client);
  /// Sends the new samples of a run.
  void send(LoadedRun& run);

 private:
  static constexpr std::size_t most_waiting = 2;

  struct View {
    WantedView wanted;
    std::set<std::uint32_t> waiting;                             ///< unacknowledged sequence numbers
    std::optional<std::pair<std::uint32_t, std::int64_t>> sent;  ///< run and end tick of the last frame
  };
  using Key = std::pair<int, std::uint16_t>;  ///< page and view

  std::vector<std::pair<Key, View>> due(std::uint32_t run, std::int64_t end) const;
  void send_view(LoadedRun& run, const Key& key, const View& view, std::int64_t end);

  Send send_;
  mutable std::mutex mutex_;
  std::map<Key, View> views_;
  std::uint32_t sequence_ = 0;
};

}  // namespace stepwire::live
