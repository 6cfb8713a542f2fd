#pragma once

#include <optional>
#include <set>
#include <tuple>
#include <utility>

namespace stepwire::plan {

/// Worklist for a fixed-point iteration over numbered items. It visits them in the order of repeated passes
/// over all items, but only those queued because of a change. The results thus equal those of full passes.
class Worklist {
 public:
  /// Queues an item: in this round if it is still ahead, else in the next one.
  void call(int who) { due_.insert({who > last_ ? round_ : round_ + 1, who}); }

  /// Returns the next item; std::nullopt if the list is empty, after which a new round starts.
  std::optional<int> next() {
    last_ = -1;
    if (due_.empty()) return std::nullopt;
    std::tie(round_, last_) = *due_.begin();
    due_.erase(due_.begin());
    return last_;
  }

 private:
  std::set<std::pair<int, int>> due_;  ///< round and item
  int round_ = 0;
  int last_ = -1;
};

}  // namespace stepwire::plan
