#include "bench/schedule.hpp"

#include <algorithm>
#include <cmath>
#include <queue>
#include <random>
#include <vector>

#include "engine/app/cluster/item_server.hpp"

namespace schedule {

namespace {

// Interval [s] at which results of a group are sent, and their largest number per message (a megabyte of
// rows).
constexpr double between_results = 1.0, most_results = 6500.0;

/// A message in transit to the writing process.
struct Message {
  double time = 0.0;
  std::size_t from = 0;
  std::size_t results = 0;
  bool requests = true;  ///< True: requests more work; false: contains results only.
  bool operator>(const Message& other) const {
    return time != other.time ? time > other.time : from > other.from;
  }
};

/// Simulation of one call, whose processes request work. Events are messages in order of time; one process
/// answers them in sequence.
class Call {
 public:
  Call(const Case& of, const Costs& costs) : of_(of), costs_(costs), workers_(of.ranks / of.parts - 1) {
    left_ = static_cast<std::size_t>(of.runs) / of.parts;
    given_.resize(workers_);
    begun_.resize(workers_);
    for (std::size_t i = 0; i < workers_; ++i) coming_.push({0.0, i});
  }

  /// Returns the time at which all runs are done.
  double end() {
    while (!coming_.empty()) {
      const Message message = coming_.top();
      coming_.pop();
      now_ = std::max(now_, message.time);
      work((message.requests ? costs_.answer : one_way()) +
           costs_.item * static_cast<double>(message.results));
      if (message.requests) answer(message);
    }
    return now_;
  }
  double busy() const { return busy_; }

 private:
  double one_way() const { return 0.5 * costs_.answer; }

  void work(double seconds) {
    now_ += seconds;
    busy_ += seconds;
  }

  /// Processes a request: notes the finished group and assigns the next one.
  void answer(const Message& message) {
    std::size_t& given = given_[message.from];
    if (of_.rule == Rule::by_number) work(one_way());  // results have a message of their own
    size_.note_group(given, given == 0 ? 0.0 : message.time - costs_.latency - begun_[message.from]);
    size_.note_answer(costs_.answer);
    given = std::min(left_, many());
    left_ -= given;
    begin(message.from, given);
  }

  void begin(std::size_t worker, std::size_t runs) {
    if (runs == 0) return;
    begun_[worker] = now_ + costs_.latency;
    const double length = length_of(runs);
    const auto pieces = static_cast<std::size_t>(
        std::ceil(std::max(length / between_results, static_cast<double>(runs) / most_results)));
    for (std::size_t i = 1; i <= pieces; ++i) {
      const double part = static_cast<double>(i) / static_cast<double>(pieces);
      coming_.push({begun_[worker] + part * length + costs_.latency, worker, runs / pieces, i == pieces});
    }
  }

  std::size_t many() const {
    if (of_.rule == Rule::by_time) return size_.next(left_, workers_);
    return std::clamp<std::size_t>(left_ / (4 * (workers_ + 1)), 1, 1000);
  }

  /// Returns the duration of a group of runs. The sum of many is nearly normal.
  double length_of(std::size_t runs) {
    const auto count = static_cast<double>(runs);
    double sum = 0.0;
    for (int i = 0; i < 12; ++i) sum += static_cast<double>(random_() >> 11u) * 0x1p-53;
    const double spread = runs == 1 ? (sum - 6.0) / 3.5 : (sum - 6.0) * std::sqrt(count / 12.0);
    return of_.run * std::max(0.5 * count, count + spread);
  }

  const Case of_;
  const Costs costs_;
  const std::size_t workers_;
  std::size_t left_ = 0;
  std::vector<std::size_t> given_;
  std::vector<double> begun_;
  std::priority_queue<Message, std::vector<Message>, std::greater<>> coming_;
  stepwire::cluster::GroupSize size_;
  std::mt19937_64 random_{1};
  double now_ = 0.0, busy_ = 0.0;
};

}  // namespace

Outcome simulate(const Case& of, const Costs& costs) {
  Call call(of, costs);  // all parts are alike
  const double end = call.end();
  return {of.runs * of.run / static_cast<double>(of.ranks) / end, call.busy() / end};
}

}  // namespace schedule
