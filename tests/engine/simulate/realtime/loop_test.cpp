// Actions of a loop at a wake-up, and the ways in which it ends.
#include <catch2/catch.hpp>

#include "blocks/register.hpp"
#include "tests/engine/simulate/realtime/fakes.hpp"

namespace stepwire::realtime {

namespace {

FakeClock* clock_of_blocks = nullptr;

/// A block whose update() takes a quarter of a millisecond.
struct Laborious {
  Input<> u{};
  Output<> y{};
  DiscreteState<> kept{};
  void outputs() { y = u; }
  void update() {
    kept = u;
    if (clock_of_blocks) clock_of_blocks->pass(ms / 4);
  }
  static void declare(Declare<Laborious>& is) {
    is.block("Laborious", {.doc = "a test"});
    is.input<&Laborious::u>({.unit = "*", .doc = "signal"});
    is.output<&Laborious::y>({.unit = "*", .doc = "the same"});
    is.state<&Laborious::kept>({.unit = "*", .doc = "the same"});
  }
};

/// A block that declares that it reads a file at every step, and does not.
struct Reader {
  Output<1> y{};
  void outputs() { y = 1.0; }
  static void declare(Declare<Reader>& is) {
    is.block(
        "Reader",
        {.doc = "a test", .timing = Timing::continuous, .not_real_time = "it reads a file at every step"});
    is.output<&Reader::y>({.doc = "one"});
  }
};

const Registry& with_test_blocks() {
  static const Registry registry = [] {
    Registry all = blocks();
    all.add<Laborious>("test");
    all.add<Reader>("test");
    return all;
  }();
  return registry;
}

const std::string doubling_yaml = R"(inputs:
  force: {unit: N, default: 3 N}
outputs:
  half: {signal: half, safe: 0.5 N}
  plain: sum
blocks:
  half: {block: Gain, gain: 0.5, u: force}
  sum: {block: DiscreteIntegrator, u: half}
step: 1 ms
record: [half, sum]
)";

}  // namespace

TEST_CASE("what the device reads is what the tick computes with, and is recorded with it") {
  LoopRig rig(doubling_yaml, options_of(4));
  rig.device.input = [](std::int64_t read) { return 10.0 * static_cast<double>(read); };
  rig.loop.serve(4);
  CHECK(rig.device.written == std::vector<double>{0, 5, 10, 15, 0.5});
  std::vector<double> row(6);
  for (const double k : {0.0, 1.0, 2.0, 3.0}) {  // each tick: a row of inputs.csv, one of signals.csv
    REQUIRE(rig.ring.pop(row.data(), 4) == 4);
    CHECK(std::vector<double>(row.begin(), row.begin() + 4) ==
          std::vector<double>{1, k * 0.001, k, 10.0 * k});
    REQUIRE(rig.ring.pop(row.data(), 6) == 6);
    CHECK(row[2] == k);
    CHECK(row[4] == 5.0 * k);
  }
}

TEST_CASE("an input that no device writes keeps its default") {
  LoopRig rig(doubling_yaml, options_of(2));
  rig.loop.serve(2);
  CHECK(rig.device.written == std::vector<double>{1.5, 1.5, 0.5});
}

TEST_CASE("an output without a safe value keeps its last one") {
  LoopRig rig(doubling_yaml, options_of(3));
  rig.loop.serve(3);
  CHECK(rig.device.last == std::vector<double>{0.5, 0.003});
}

TEST_CASE("a wake-up runs the ticks of one period, and writes what the first of them computes") {
  LoopOptions options = options_of(3);
  options.rate = 250.0;
  LoopRig rig(counting_yaml, options);
  rig.loop.serve(3);
  CHECK(rig.device.written == std::vector<double>{1, 5, 9, -1});
  CHECK(rig.device.written_at == std::vector<std::int64_t>{0, 4 * ms, 8 * ms, 8 * ms});
  CHECK(rig.rows(5).size() == 12);
  CHECK(rig.loop.simulation().tick() == 12);
}

TEST_CASE("outputs are written before the states are advanced") {
  const plan::Plan plan = plan_text(
      "step: 1 ms\noutputs: {held: held}\nblocks:\n  held: {block: Laborious, u: wave}\n"
      "  wave: {block: Sine, frequency: 1 Hz}\n",
      {}, with_test_blocks());
  FakeClock clock;
  FakeDevice device(clock);
  Loop loop(plan, options_of(3), device, clock, nullptr);
  clock_of_blocks = &clock;
  loop.serve(3);
  clock_of_blocks = nullptr;
  CHECK(loop.measurements().response().max() == 0);
  CHECK(loop.measurements().step().min() == ms / 4);
  for (const GroupCost& cost : loop.group_costs())
    if (cost.type == "Laborious") CHECK(cost.blocks == 1);
}

TEST_CASE("the cost of a block type is sampled where it arises") {
  const plan::Plan plan = plan_text(
      "step: 1 ms\nblocks:\n  a: {block: Laborious, u: wave}\n  b: {block: Laborious, u: wave}\n"
      "  wave: {block: Sine, frequency: 1 Hz}\n  half: {block: Gain, gain: 0.5, u: wave}\n",
      {}, with_test_blocks());
  FakeClock clock;
  FakeDevice device(clock);
  Loop loop(plan, options_of(200), device, clock, nullptr);
  clock_of_blocks = &clock;
  loop.serve(200);
  clock_of_blocks = nullptr;
  const auto costs = loop.group_costs();
  REQUIRE(costs.size() == 3);
  CHECK(costs[0].type == "Laborious");
  CHECK(costs[0].blocks == 2);
  CHECK(costs[0].mean == ms / 2);
  CHECK(costs[1].mean == 0.0);
  std::int64_t samples = 0;
  for (const GroupCost& cost : costs) samples += cost.samples;
  CHECK(samples > 100);  // the others are of nothing, to know what looking costs
  CHECK(samples < 200);
}

TEST_CASE("a loop that stops hands out the safe values before it advances the states") {
  const plan::Plan plan = plan_text(
      "step: 1 ms\noutputs: {held: {signal: held, safe: 7}}\nblocks:\n  held: {block: Laborious, u: wave}\n"
      "  wave: {block: Sine, frequency: 1 Hz}\n",
      {}, with_test_blocks());
  FakeClock clock;
  FakeDevice device(clock);
  device.size = 1;
  device.read_takes[4] = 3 * ms / 2;
  Loop loop(plan, options_of(50, Overrun::Kind::stop, 1), device, clock, nullptr);
  clock_of_blocks = &clock;
  loop.serve(50);
  clock_of_blocks = nullptr;
  CHECK(loop.end() == Loop::End::stopped);
  CHECK(device.written.back() == 7.0);
  CHECK(device.written_at.back() == device.written_at[4]);
}

TEST_CASE("an interrupt ends the loop at its next wake-up with the safe values") {
  const plan::Plan plan = plan_text(counting_yaml);
  FakeClock clock;
  FakeDevice device(clock);
  device.size = 1;
  std::atomic<bool> flag = false;
  LoopOptions options = options_of(100);
  options.interrupt = &flag;
  Loop loop(plan, options, device, clock, nullptr);
  clock.at_sleep = [&](std::int64_t sleeps) { flag = sleeps == 6; };
  loop.serve(100);
  CHECK(loop.end() == Loop::End::interrupted);
  CHECK(device.written == std::vector<double>{1, 2, 3, 4, 5, -1});
}

TEST_CASE("a value that is not finite is never written; the loop ends with the safe values and says why") {
  LoopRig rig(doubling_yaml, options_of(100));
  rig.device.input = [](std::int64_t read) { return read == 3 ? NAN : 1.0; };
  rig.loop.serve(100);
  CHECK(rig.loop.end() == Loop::End::fault);
  CHECK(rig.device.written == std::vector<double>{0.5, 0.5, 0.5, 0.5});
  CHECK(rig.device.last[1] == 0.001);
  CHECK(rig.loop.measurements().wake_up().count() == 4);
  CHECK(rig.loop.measurements().response().count() == 4);
  CHECK_THAT(rig.loop.simulation().fault()->fault.text(),
             Catch::Contains("test.yaml:") && Catch::Contains("became nan at 0.003 s"));
}

TEST_CASE("a notice that ends a run ends the loop after the step in which it is raised") {
  LoopRig rig(R"(step: 1 ms
outputs: {count: {signal: count, safe: -1}}
blocks:
  count: {block: Sum, u: [1, last]}
  last: {block: UnitDelay, u: count}
  few: {block: Compare, u: count, operator: "<", to: 3}
  stays_small: {block: Assert, u: few}
)",
              options_of(100));
  rig.loop.serve(100);
  CHECK(rig.loop.end() == Loop::End::fault);
  CHECK(rig.device.written == std::vector<double>{1, 2, 3, -1});
  CHECK(rig.loop.simulation().fault()->block == "stays_small");
}

TEST_CASE("neither the file's stop nor its stop_when ends a loop") {
  LoopRig rig(counting_yaml + "stop_when: count > 5\n", options_of(50));
  rig.loop.serve(50);
  CHECK(rig.loop.end() == Loop::End::done);
  CHECK(rig.loop.simulation().tick() == 50);
  CHECK(rig.rows(5).size() == 50);
}

TEST_CASE("a loop that is served in slices goes on where it was, safe in between") {
  LoopRig rig(counting_yaml, options_of(5));
  rig.loop.serve(2);
  CHECK_FALSE(rig.loop.ended());
  rig.clock.pass(1000 * ms);
  rig.loop.serve(10);
  CHECK(rig.loop.ended());
  CHECK(rig.device.written == std::vector<double>{1, 2, -1, 3, 4, 5, -1});
  CHECK(rig.loop.deadlines().missed() == 0);
  CHECK(rig.loop.measurements().wake_up().max() == 0);
}

TEST_CASE("a block that is not fit for a loop is refused with its place and why") {
  const plan::Plan plan = plan_text("blocks:\n  log: {block: Reader}\n", {}, with_test_blocks());
  CHECK_THROWS_WITH(require_fit_for_loop(plan),
                    "test.yaml:2:8: log: Reader is not fit for a real-time loop: it reads a file at every "
                    "step; 'stepwire run' takes it");
  FakeClock clock;
  FakeDevice device(clock);
  CHECK_THROWS_AS(Loop(plan, options_of(1), device, clock, nullptr), yaml::Error);
}

TEST_CASE("a period that is no whole number of steps is refused with both and with what would be right") {
  const plan::Plan plan = plan_text("step: 1 ms\nstop: 1 s\nblocks:\n  one: {block: Constant, value: 1}\n");
  CHECK(ticks_per_period(plan.diagram, 1000.0) == 1);
  CHECK(ticks_per_period(plan.diagram, 100.0) == 10);
  CHECK_THROWS_WITH(ticks_per_period(plan.diagram, 1500.0),
                    "test.yaml:1:7: step: the period of 1500 Hz, 0.000666667 s, is no whole multiple of the "
                    "step 0.001 s; e.g. a rate of 1000 Hz, or a step of 0.000666666667 s, would be");
  CHECK_THROWS_WITH(ticks_per_period(plan.diagram, 400.0),
                    Catch::Contains("a rate of 333.333333 Hz") || Catch::Contains("a rate of 500 Hz"));
}

}  // namespace stepwire::realtime
