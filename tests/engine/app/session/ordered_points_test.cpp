// Runs of a sweep that are looked at one by one, in their order, while several threads make them.
#include "engine/app/session/ordered_points.hpp"

#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <chrono>
#include <stdexcept>
#include <thread>

#include "blocks/register.hpp"
#include "engine/app/session/session.hpp"
#include "tests/engine/base/table/scratch.hpp"

namespace stepwire::session {

namespace {

constexpr unsigned threads = 4;
constexpr std::size_t runs = 200;
constexpr std::size_t bytes_of_a_run =
    3 * 501 * sizeof(double) + 4096;  // three columns, and what is about them

const Registry& library() {
  static const Registry registry = blocks();
  return registry;
}

/// A sweep whose neighbours are of different plans: their times are others.
std::string sweep_of_two_plans() {
  std::string stops, gains;
  for (std::size_t i = 0; i < runs; ++i) {
    stops += fmt::format("{}{} ms", i == 0 ? "" : ", ", i % 2 == 0 ? 500 : 400);
    gains += fmt::format("{}{}", i == 0 ? "" : ", ", i + 1);
  }
  return fmt::format(
      "stepwire: 1\ntitle: t\nstep: 1 ms\nstop: 500 ms\nparameters: {{gain: 1}}\n"
      "blocks: {{t: {{block: Clock}}, y: {{block: Gain, u: t, gain: $gain}}}}\nrecord: [t, y]\n"
      "sweep: {{together: true, stop: [{}], gain: [{}]}}\n"
      "claims: [{{that: the last one, max: y in s, each_run: true, at_most: 100 s}}]\n",
      stops, gains);
}

/// Holds the first run back until more than `bytes` of others wait for it, and long enough for more to come.
struct FirstIsLate : run::RunObserver {
  FirstIsLate(const OrderedPoints& of, std::size_t wait_for, std::function<void()> then_do = {})
      : points(of), bytes(wait_for), then(std::move(then_do)) {}

  void begin(const run::ObservedRun& run) override {
    using namespace std::chrono_literals;
    if (run.index != 0) return;
    const auto end = std::chrono::steady_clock::now() + 60s;
    while (points.peak() <= bytes && std::chrono::steady_clock::now() < end) std::this_thread::sleep_for(1ms);
    std::this_thread::sleep_for(50ms);
    if (then) then();
  }

  const OrderedPoints& points;
  std::size_t bytes;
  std::function<void()> then;
};

/// A session that passes the runs of a sweep, of which this many bytes may wait.
struct Passing {
  explicit Passing(std::size_t most_waiting) : most(most_waiting) {
    folder.file("sweep.yaml", sweep_of_two_plans());
    model = session.load(folder.path("sweep.yaml"));
    points.emplace(model, most);
  }

  void run() { session.run(model, *points, run::ExecutionMode::interpreted, threads); }

  std::size_t most;
  Scratch folder;
  Session session{library()};
  LoadedModel model;
  std::optional<OrderedPoints> points;
};

}  // namespace

TEST_CASE("threads wait for a late run once what others gave takes too much memory") {
  Passing passing(20 * bytes_of_a_run);
  FirstIsLate late(*passing.points, passing.most);
  passing.session.monitor().observers = {&late};
  passing.run();
  CHECK(passing.points->peak() > passing.most);
  CHECK(passing.points->peak() <= passing.most + threads * bytes_of_a_run);
  const Outcome outcome = passing.points->outcome();
  CHECK_FALSE(outcome.result.interrupted);
  REQUIRE(outcome.verdicts.size() == 1);
  CHECK(outcome.verdicts[0].holds);
  CHECK(outcome.result.ticks == (500 + 400) * static_cast<std::int64_t>(runs) / 2);
}

TEST_CASE("where nothing may wait, neighbours of different plans are still all run") {
  Passing passing(0);
  passing.run();
  CHECK(passing.points->outcome().result.ticks == (500 + 400) * static_cast<std::int64_t>(runs) / 2);
}

TEST_CASE("threads that wait for a run go on once it throws, or is interrupted") {
  Passing passing(5 * bytes_of_a_run);
  std::atomic<bool> interrupt = false;
  SECTION("throws") {
    FirstIsLate late(*passing.points, passing.most, [] { throw std::runtime_error("the first run"); });
    passing.session.monitor().observers = {&late};
    CHECK_THROWS_WITH(passing.run(), "the first run");
  }
  SECTION("interrupted") {
    FirstIsLate late(*passing.points, passing.most, [&] { interrupt = true; });
    passing.session.monitor().observers = {&late};
    passing.session.monitor().interrupt = &interrupt;
    passing.run();
    CHECK(passing.points->outcome().result.interrupted);
  }
}

}  // namespace stepwire::session
