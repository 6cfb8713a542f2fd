#pragma once

#include <cstddef>
#include <memory>

namespace stepwire::realtime {

/// Lock-free ring that passes rows of numbers from one thread to one other; neither waits for the other.
class RowRing {
 public:
  /// Allocates memory for `capacity` numbers and writes all of it once.
  explicit RowRing(std::size_t capacity);
  ~RowRing();
  RowRing(const RowRing&) = delete;
  RowRing& operator=(const RowRing&) = delete;

  /// Writes a whole row. Returns false, with the ring unchanged, if there is no space. For the writing
  /// thread.
  bool push(const double* row, std::size_t count);
  /// Reads up to `most` numbers in order. Returns their count. For the reading thread.
  std::size_t pop(double* numbers, std::size_t most);

 private:
  struct Queue;
  std::unique_ptr<Queue> queue_;
};

}  // namespace stepwire::realtime
