#include "engine/simulate/realtime/row_ring.hpp"

#include <boost/lockfree/spsc_queue.hpp>

namespace stepwire::realtime {

struct RowRing::Queue {
  explicit Queue(std::size_t capacity) : numbers(capacity) {}
  boost::lockfree::spsc_queue<double> numbers;
};

RowRing::RowRing(std::size_t capacity) : queue_(std::make_unique<Queue>(capacity)) {
  // Writes all elements once: memory is mapped by the first write, which would delay the loop.
  while (queue_->numbers.push(0.0)) {
  }
  queue_->numbers.reset();
}

RowRing::~RowRing() = default;

bool RowRing::push(const double* row, std::size_t count) {
  // A push may write part of a row if space is short. Only this thread pushes, so free space stays free.
  return queue_->numbers.write_available() >= count && queue_->numbers.push(row, count) == count;
}

std::size_t RowRing::pop(double* numbers, std::size_t most) {
  return queue_->numbers.pop(numbers, most);
}

}  // namespace stepwire::realtime
