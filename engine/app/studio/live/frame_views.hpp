#pragma once

#include <functional>
#include <map>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "engine/app/studio/live/loaded_run.hpp"
#include "engine/base/json/json.hpp"

namespace stepwire::live {

/// What a view of a page shows: a stretch of time, or the newest seconds.
struct WantedView {
  std::vector<std::size_t> columns;
  double from = 0.0, to = 0.0;   ///< [s]
  std::optional<double> follow;  ///< [s]
  std::size_t pixels = 1;
};

/// The views of all pages, and what each has been sent. Samples wait for nobody: a view gets its newest
/// window once it has acknowledged all but one of the frames before. From any thread.
class FrameViews {
 public:
  using Send = std::function<void(int client, std::string bytes)>;

  explicit FrameViews(Send send) : send_(std::move(send)) {}

  /// Puts these views, as `data.want` gives them, in the place of all that the page had. Throws
  /// std::runtime_error.
  void want(int client, const json::Json& views);
  void acknowledge(int client, std::uint32_t sequence);
  void left(int client);
  /// Sends what is new in a run.
  void send(LoadedRun& run);

 private:
  static constexpr std::size_t most_waiting = 2;

  struct View {
    WantedView wanted;
    std::set<std::uint32_t> waiting;                             ///< to be acknowledged
    std::optional<std::pair<std::uint32_t, std::int64_t>> sent;  ///< of which run, up to which tick
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
