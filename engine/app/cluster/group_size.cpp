#include "engine/app/cluster/group_size.hpp"

#include <algorithm>
#include <cmath>

namespace stepwire::cluster {

namespace {

constexpr double share_of_answers = 0.25;  // Largest fraction of the server's time for answers.
constexpr double longest = 10.0;           // Longest duration of a group [s], which bounds lost work.
constexpr std::size_t first_group = 8;     // Group size before the first measurement: the lanes of a run.
constexpr std::size_t most = 100'000;      // Largest number of items whose numbers fit into a message.
constexpr std::size_t groups_left = 4;     // Groups per process that the remaining items make.
constexpr double forget_beyond = 1e4;      // Number of notes after which old ones lose weight.

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
  // Shortest duration of a group that leaves the server mostly idle [s].
  const double busy = answer_.value() * static_cast<double>(processes) / share_of_answers;
  const std::size_t share = left / processes + 1;
  const std::size_t fewest = std::min(whole(busy / item), share);
  return std::min({std::max(even, fewest), whole(longest / item), most});
}

}  // namespace stepwire::cluster
