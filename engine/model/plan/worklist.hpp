#pragma once

#include <optional>
#include <set>
#include <tuple>
#include <utility>

namespace stepwire::plan {

/// Whose turn it is where all would be asked in order, round after round, until nobody has anything new to
/// say; only those are asked whom something new concerns.
class Worklist {
 public:
  /// Gives somebody a turn: in this round if theirs is still to come, or else in the next.
  void call(int who) { due_.insert({who > last_ ? round_ : round_ + 1, who}); }

  /// Who is next; nobody once all is quiet, after which a new round starts.
  std::optional<int> next() {
    last_ = -1;
    if (due_.empty()) return std::nullopt;
    std::tie(round_, last_) = *due_.begin();
    due_.erase(due_.begin());
    return last_;
  }

 private:
  std::set<std::pair<int, int>> due_;  ///< round and who
  int round_ = 0;
  int last_ = -1;
};

}  // namespace stepwire::plan
