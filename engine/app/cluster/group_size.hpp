#pragma once

#include <cstddef>

namespace stepwire::cluster {

/// Size of the group of items that a process is given at once.
/// Large groups keep the server mostly idle; small ones let all processes end together and lose little work
/// with a process. The rule is guided self-scheduling: each request gets a fixed fraction of an even share of
/// the remaining items, so groups shrink towards the end. A group is at least as long as the measured cost of
/// answers demands, and at most 10 s long.
class GroupSize {
 public:
  /// Adds a group of items that a process has done in `seconds`.
  void note_group(std::size_t items, double seconds);
  /// Adds the time [s] of answering a message, without storing the results in it.
  void note_answer(double seconds);

  /// Returns the size of the next group, with `left` items not given out yet and `processes` processes.
  std::size_t next(std::size_t left, std::size_t processes) const;
  /// Returns the mean time of an answer [s]; 0 before the first note.
  double answer() const { return answer_.value(); }

 private:
  /// Mean that forgets: old values lose weight.
  struct Mean {
    double sum = 0.0, count = 0.0;
    void add(double value, double weight);
    double value() const { return count > 0.0 ? sum / count : 0.0; }
  };

  Mean item_, answer_;  ///< [s]
};

}  // namespace stepwire::cluster
