#pragma once

#include <cstddef>

namespace stepwire::cluster {

/// How many items a process is given at once: so many that the messages of all processes leave the one that
/// answers them mostly idle, and so few that all end at about the same time and little is lost with one.
class GroupSize {
 public:
  /// Notes that a process has done a group of items in so many seconds.
  void note_group(std::size_t items, double seconds);
  /// Notes what it took to answer a message, beside keeping what it brought [s].
  void note_answer(double seconds);

  /// Of `left` items that no process has yet, for one of so many.
  std::size_t next(std::size_t left, std::size_t processes) const;
  /// What answers took [s]; 0 where none was noted.
  double answer() const { return answer_.value(); }

 private:
  /// A mean in which what is long ago counts less and less.
  struct Mean {
    double sum = 0.0, count = 0.0;
    void add(double value, double weight);
    double value() const { return count > 0.0 ? sum / count : 0.0; }
  };

  Mean item_, answer_;  ///< [s]
};

}  // namespace stepwire::cluster
