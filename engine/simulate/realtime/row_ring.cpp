#include "engine/simulate/realtime/row_ring.hpp"

#include <boost/lockfree/spsc_queue.hpp>

namespace stepwire::realtime {

struct RowRing::Queue {
  explicit Queue(std::size_t capacity) : numbers(capacity) {}
  boost::lockfree::spsc_queue<double> numbers;
};

RowRing::RowRing(std::size_t capacity) : queue_(std::make_unique<Queue>(capacity)) {
  // Memory that nobody has written yet is not there before the first write, which would wait for it.
  while (queue_->numbers.push(0.0)) {
  }
  queue_->numbers.reset();
}

RowRing::~RowRing() = default;

bool RowRing::push(const double* row, std::size_t count) {
  // A push may take the part for which there is room; only this thread pushes, so what is free stays free.
  return queue_->numbers.write_available() >= count && queue_->numbers.push(row, count) == count;
}

std::size_t RowRing::pop(double* numbers, std::size_t most) {
  return queue_->numbers.pop(numbers, most);
}

}  // namespace stepwire::realtime
