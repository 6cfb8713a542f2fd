#pragma once

#include <cstddef>
#include <memory>

namespace stepwire::realtime {

/// Hands rows of numbers from one thread to one other without a lock; neither ever waits for the other.
class RowRing {
 public:
  /// Takes memory for so many numbers, and touches all of it.
  explicit RowRing(std::size_t capacity);
  ~RowRing();
  RowRing(const RowRing&) = delete;
  RowRing& operator=(const RowRing&) = delete;

  /// The thread that gives: a whole row, or, where there is no room for it, nothing and false.
  bool push(const double* row, std::size_t count);
  /// The thread that takes: up to `most` numbers, in their order. Returns how many.
  std::size_t pop(double* numbers, std::size_t most);

 private:
  struct Queue;
  std::unique_ptr<Queue> queue_;
};

}  // namespace stepwire::realtime
