#pragma once

#include <functional>
#include <map>
#include <vector>

#include "engine/simulate/realtime/loop.hpp"
#include "tests/support/plan_text.hpp"

namespace stepwire {

inline constexpr std::int64_t ms = 1'000'000;  // [ns]

/// A clock that advances only by pass() and by sleeping.
class FakeClock : public realtime::LoopClock {
 public:
  std::int64_t now() override { return now_; }
  void sleep_until(std::int64_t deadline) override {
    if (sleeps == 0) first = deadline;
    if (now_ < deadline) now_ = deadline;
    const auto late = late_after.find(sleeps++);
    if (late != late_after.end()) now_ += late->second;
    if (at_sleep) at_sleep(sleeps);
  }
  void pass(std::int64_t time) { now_ += time; }
  /// Time since the first deadline [ns].
  std::int64_t elapsed() const { return now_ - first; }

  std::map<std::int64_t, std::int64_t> late_after;  ///< oversleep [ns] of the n-th sleep, from 0
  std::function<void(std::int64_t)> at_sleep;       ///< called with the number of sleeps
  std::int64_t sleeps = 0, first = 0;

 private:
  std::int64_t now_ = 5'000 * ms;
};

/// A device that stores its outputs, and takes the times that a test sets.
class FakeDevice : public realtime::Device {
 public:
  explicit FakeDevice(FakeClock& clock) : clock_(clock) {}

  void read(double* inputs) noexcept override {
    const auto takes = read_takes.find(reads);
    if (takes != read_takes.end()) clock_.pass(takes->second);
    if (input) *inputs = input(reads);
    ++reads;
  }
  void write(const double* outputs) noexcept override {
    written.push_back(size > 0 ? outputs[0] : 0.0);
    written_at.push_back(clock_.elapsed());
    last.assign(outputs, outputs + size);
    clock_.pass(write_takes);
  }

  std::map<std::int64_t, std::int64_t> read_takes;  ///< n-th read, from 0 [ns]
  std::int64_t write_takes = 0;                     ///< each, after the outputs are taken [ns]
  std::function<double(std::int64_t)> input;        ///< first input at the n-th read
  std::size_t size = 0;                             ///< numbers of the outputs
  std::int64_t reads = 0;
  std::vector<double> written;  ///< first output of each write
  std::vector<std::int64_t> written_at;
  std::vector<double> last;

 private:
  FakeClock& clock_;
};

/// Counts its ticks: count is 1, 2, 3, ...; held at -1 once it no longer runs.
inline const std::string counting_yaml = R"(step: 1 ms
stop: 3 ms
outputs: {count: {signal: count, safe: -1}}
blocks:
  count: {block: Sum, u: [1, last]}
  last: {block: UnitDelay, u: count}
record: [count]
)";

/// A loop over a diagram with a clock and an outside world of the test's own.
struct LoopRig {
  explicit LoopRig(const std::string& yaml, const realtime::LoopOptions& options = {},
                   std::size_t ring_numbers = 1 << 16)
      : plan(plan_text(yaml)),
        ring(ring_numbers),
        recorder(plan, ring),
        loop(plan, options, device, clock, &recorder) {
    for (const diagram::DiagramOutput& output : plan.diagram.outputs)
      device.size += static_cast<std::size_t>(plan.slot(output.signal).size);
  }

  /// Returns the content of the ring, row by row: index of the file, time, tick, ...
  std::vector<std::vector<double>> rows(std::size_t width) {
    std::vector<std::vector<double>> rows;
    std::vector<double> row(width);
    while (ring.pop(row.data(), width) == width) rows.push_back(row);
    return rows;
  }

  plan::Plan plan;
  FakeClock clock;
  FakeDevice device{clock};
  realtime::RowRing ring;
  realtime::LoopRecorder recorder;
  realtime::Loop loop;
};

inline realtime::LoopOptions options_of(std::int64_t deadlines,
                                        realtime::Overrun::Kind kind = realtime::Overrun::Kind::skip,
                                        std::int64_t misses = 0) {
  realtime::LoopOptions options;
  options.deadlines = deadlines;
  options.overrun = {kind, misses};
  return options;
}

}  // namespace stepwire
