#include <catch2/catch.hpp>

#include "tests/support/plan_text.hpp"
#include "tests/support/run_text.hpp"

namespace stepwire::plan {

namespace {

/// The time in milliseconds, as a block of the given period sees it at `tick`.
double held(int tick, int period) {
  return tick / period * period;
}

const std::string milliseconds = "  t: {block: Clock}\n  ms: {block: Gain, gain: 1000, u: t}\n";

void check_column(const table::Table& run, const std::string& name, int (*expected)(int tick)) {
  const auto& values = column(run, name);
  for (std::size_t tick = 0; tick < values.size(); ++tick) {
    INFO(name << " at tick " << tick);
    CHECK(values[tick] == Approx(expected(static_cast<int>(tick))).margin(1e-9));
  }
}

}  // namespace

TEST_CASE("what stands behind a sampled block runs at its ticks and holds in between") {
  const table::Table run = run_text("step: 1 ms\nstop: 10 ms\nblocks:\n" + milliseconds + R"(
  sampled: {block: ZeroOrderHold, u: ms, every: 3 ms}
  behind: {block: Gain, gain: 10, u: sampled}
  both: {block: Sum, u: [sampled, ms]}
record: [sampled, behind, both]
)");
  check_column(run, "sampled", [](int tick) { return tick / 3 * 3; });
  check_column(run, "behind", [](int tick) { return tick / 3 * 30; });
  check_column(run, "both", [](int tick) { return tick / 3 * 3 + tick; });
}

TEST_CASE("held values cross between rates both ways") {
  const table::Table run = run_text("step: 1 ms\nstop: 40 ms\nblocks:\n" + milliseconds + R"(
  fast: {block: ZeroOrderHold, u: slow, every: 1 ms}
  slow: {block: ZeroOrderHold, u: middle, every: 10 ms}
  middle: {block: ZeroOrderHold, u: ms, every: 3 ms}
  back: {block: ZeroOrderHold, u: slow, every: 3 ms}
record: [fast, slow, middle, back]
)");
  check_column(run, "middle", [](int tick) { return tick / 3 * 3; });
  check_column(run, "slow", [](int tick) { return tick / 10 * 10 / 3 * 3; });
  check_column(run, "fast", [](int tick) { return tick / 10 * 10 / 3 * 3; });
  check_column(run, "back", [](int tick) { return tick / 3 * 3 / 10 * 10 / 3 * 3; });
}

TEST_CASE("delays of several periods remember each for its own period") {
  const table::Table run = run_text("step: 1 ms\nstop: 40 ms\nblocks:\n" + milliseconds + R"(
  slow: {block: UnitDelay, u: ms, every: 10 ms}
  fast: {block: UnitDelay, u: ms, every: 1 ms}
record: [slow, fast]
)");
  const auto& slow = column(run, "slow");
  for (int tick = 0; tick <= 40; ++tick)
    CHECK(slow[static_cast<std::size_t>(tick)] == Approx(std::max(0.0, held(tick, 10) - 10)));
  check_column(run, "fast", [](int tick) { return std::max(0, tick - 1); });
}

TEST_CASE(
    "a delay in a loop takes the period of what feeds the loop, in whatever order the file lists them") {
  const std::string source = "  ms: {block: Clock}\n  pulse: {block: ZeroOrderHold, u: ms, every: 10 ms}\n";
  const std::string count = "  count: {block: Sum, u: [one, last]}\n";
  const std::string one = "  one: {block: Gain, u: pulse}\n";
  const std::string last = "  last: {block: UnitDelay, u: count}\n";
  for (const std::string& blocks : {source + one + count + last, last + count + one + source}) {
    const Plan plan = plan_text("step: 1 ms\nstop: 40 ms\nblocks:\n" + blocks);
    for (std::size_t b = 0; b < plan.blocks.size(); ++b) {
      if (plan.diagram.blocks[b].name == "ms") continue;
      INFO(plan.diagram.blocks[b].name);
      CHECK(plan.blocks[b].rate == Rate{Rate::Kind::discrete, 10});
    }
  }
}

TEST_CASE("blocks that act at ticks act at every step where nothing gives them a period") {
  const table::Table run = run_text(R"(
step: 1 s
stop: 3 s
blocks:
  count: {block: Sum, u: [1, last]}
  last: {block: UnitDelay, u: count}
record: [count]
)");
  CHECK(column(run, "count") == std::vector<double>{1, 2, 3, 4});
}

TEST_CASE("a period that is not a whole number of steps is refused with both numbers") {
  const auto refused = faults_of("step: 1 ms\nblocks:\n  z: {block: ZeroOrderHold, u: 1, every: 2.5 ms}\n");
  REQUIRE(refused.size() == 1);
  CHECK(
      refused[0] ==
      "test.yaml:3:42: z.every: 0.0025 s is not a whole multiple of the step 0.001 s; e.g. 0.003 s would be");
}

TEST_CASE("a stop and a recording period that are no whole number of steps are refused with both numbers") {
  const auto refused =
      faults_of("step: 0.3 s\nstop: 1 s\nblocks:\n  c: {block: Clock}\nrecord: {every: 0.5 s, signals: c}\n");
  REQUIRE(refused.size() == 2);
  CHECK(refused[0] ==
        "test.yaml:2:7: stop: 1 s is not a whole multiple of the step 0.3 s; e.g. 0.9 s would be");
  CHECK(refused[1] ==
        "test.yaml:5:17: record.every: 0.5 s is not a whole multiple of the step 0.3 s; e.g. 0.6 s would be");
}

TEST_CASE("times that are whole in decimal but not in binary are whole") {
  for (const auto& [step, stop, steps] :
       {std::tuple{"0.1 ms", "6 s", 60000}, {"0.1 s", "0.3 s", 3}, {"1 us", "0.7 s", 700000}})
    CHECK(plan_text(std::string("step: ") + step + "\nstop: " + stop + "\nblocks:\n  c: {block: Clock}\n")
              .steps == steps);
}

TEST_CASE("a block with a continuous state takes no period of its own") {
  const auto refused = faults_of("solver: rk4\nblocks:\n  x: {block: Integrator, u: 1, every: 1 s}\n");
  REQUIRE(refused.size() == 1);
  CHECK_THAT(
      refused[0],
      Catch::StartsWith("test.yaml:3:39: x.every: Integrator has a continuous state and follows the solver"));
}

TEST_CASE("a continuous state without a solver is refused, a discrete diagram needs none") {
  const auto refused = faults_of("blocks:\n  x: {block: Integrator, u: 1}\n");
  REQUIRE(refused.size() == 1);
  CHECK_THAT(refused[0],
             Catch::StartsWith(
                 "test.yaml:2:6: x: Integrator has a continuous state, and the diagram names no solver"));
  CHECK(faults_of("blocks:\n  x: {block: UnitDelay, u: 1}\n").empty());
}

}  // namespace stepwire::plan
