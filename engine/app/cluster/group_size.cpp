#include "engine/app/cluster/group_size.hpp"

#include <algorithm>
#include <cmath>

namespace stepwire::cluster {

namespace {

constexpr double share_of_answers = 0.25;  // of the time, that answers may take
constexpr double longest = 10.0;           // that a group may take [s]: as much is lost with a process
constexpr std::size_t first_group = 8;     // while nothing is known; as many runs as go in lanes
constexpr std::size_t most = 100'000;      // whose numbers a message has room for
constexpr std::size_t groups_left = 4;     // for each process, of which one of equal length takes the next
constexpr double forget_beyond = 1e4;      // notes

std::size_t whole(double number) {
  return static_cast<std::size_t>(std::clamp(std::ceil(number), 1.0, 1e15));
}

}  // namespace

void GroupSize::Mean::add(double value, double weight) {
  sum += value;
  count += weight;
  if (count < forget_beyond * weight) return;
  sum *= 0.5;
  count *= 0.5;
}

void GroupSize::note_group(std::size_t items, double seconds) {
  if (items > 0) item_.add(std::max(seconds, 0.0), static_cast<double>(items));
}

void GroupSize::note_answer(double seconds) {
  answer_.add(std::max(seconds, 0.0), 1.0);
}

std::size_t GroupSize::next(std::size_t left, std::size_t processes) const {
  const std::size_t even = std::max<std::size_t>(1, left / (groups_left * processes));
  const double item = item_.value();
  if (item <= 0.0) return std::min(even, first_group);
  const double busy = answer_.value() * static_cast<double>(processes) / share_of_answers;  // [s]
  const std::size_t share = left / processes + 1;
  const std::size_t fewest = std::min(whole(busy / item), share);
  return std::min({std::max(even, fewest), whole(longest / item), most});
}

}  // namespace stepwire::cluster
