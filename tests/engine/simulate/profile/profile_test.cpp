// Profile of blocks that take exactly 5, 3 and 7 ns, by a clock that only they advance.
#include <algorithm>
#include <catch2/catch.hpp>

#include "blocks/register.hpp"
#include "engine/simulate/profile/profile.hpp"
#include "engine/simulate/run/executor.hpp"
#include "tests/support/plan_text.hpp"

namespace stepwire::profile {

namespace {

double now;  // [ns]

struct Slow {
  Input<> u{};
  Output<> y{};
  State<> x{};

  void outputs() {
    now += 5.0;
    y = u;
  }
  void derivatives() {
    now += 3.0;
    x.derivative = u;
  }
  static void declare(Declare<Slow>& is) {
    is.block("Slow", {.doc = "a test"});
    is.input<&Slow::u>({.shape = "n", .doc = "signal"});
    is.output<&Slow::y>({.shape = "n", .doc = "the same"});
    is.state<&Slow::x>({.shape = "n", .doc = "its integral"});
  }
};

struct Tick {
  Input<> u{};
  Output<> y{};
  DiscreteState<> x{};

  void outputs() {
    now += 5.0;
    y = x;
  }
  void update() {
    now += 7.0;
    x = u;
  }
  static void declare(Declare<Tick>& is) {
    is.block("Tick", {.doc = "a test"});
    is.input<&Tick::u>({.shape = "n", .doc = "signal", .feedthrough = false});
    is.output<&Tick::y>({.shape = "n", .doc = "the signal before"});
    is.state<&Tick::x>({.shape = "n", .doc = "likewise"});
  }
};

Registry with_slow_blocks() {
  Registry registry = blocks();
  registry.add<Slow>("test");
  registry.add<Tick>("test");
  return registry;
}

/// A reading takes 20 ns.
double fake_clock() {
  now += 20.0;
  return now * 1e-9;
}

Profile profile_of(const std::string& yaml) {
  static const Registry registry = with_slow_blocks();
  const plan::Plan plan = plan_text(yaml, {}, registry);
  return profile_plan(plan, {fake_clock});
}

const BlockCost& block(const Profile& profile, const std::string& name) {
  const auto found = std::find_if(profile.blocks.begin(), profile.blocks.end(),
                                  [&](const BlockCost& cost) { return cost.name == name; });
  REQUIRE(found != profile.blocks.end());
  return *found;
}

Approx nanoseconds(double value) {
  return Approx(value * 1e-9).epsilon(1e-6).margin(1e-15);
}

const std::string loop = R"(blocks:
  t: {block: Ramp, slope: 1}
  a: {block: Slow, u: t}
  b: {block: Slow, u: a}
  d: {block: Tick, u: t, every: 5 s}
step: 1 s
stop: 200 s
solver: rk4
)";

}  // namespace

TEST_CASE("each block of a profile has the calls of the whole run and what they take") {
  const Profile profile = profile_of(loop);
  CHECK(profile.ticks == 200);
  const BlockCost& a = block(profile, "a");
  CHECK(a.type == "Slow");
  CHECK(a.phases[1].calls == 201);      // at every tick, both ends included
  CHECK(a.phases[2].calls == 200 * 3);  // at three later stages of each step
  CHECK(a.phases[3].calls == 200 * 4);
  CHECK(a.phases[4].calls == 0);
  CHECK(a.phases[1].seconds == nanoseconds(201 * 5));
  CHECK(a.phases[2].seconds == nanoseconds(600 * 5));
  CHECK(a.phases[3].seconds == nanoseconds(800 * 3));
  const BlockCost& d = block(profile, "d");
  CHECK(d.phases[1].calls == 41);  // at 0, 5, ..., 200 s
  CHECK(d.phases[4].calls == 40);  // nothing is updated at the stop
  CHECK(d.phases[1].seconds == nanoseconds(41 * 5));
  CHECK(d.phases[4].seconds == nanoseconds(40 * 7));
}

TEST_CASE("all parts of a profile add up to the whole run, where nothing else takes time") {
  const Profile profile = profile_of(loop);
  const double blocks = 201 * 2 * 5 + 600 * 5 + 2 * 800 * 3 + 41 * 5 + 40 * 7;
  CHECK(profile.seconds == nanoseconds(blocks));
  CHECK(profile.left() == nanoseconds(0.0));
  CHECK(block(profile, "t").total().seconds == nanoseconds(0.0));
}

TEST_CASE("the blocks of a profile are listed from the most expensive on") {
  const Profile profile = profile_of(loop);
  const bool sorted =
      std::is_sorted(profile.blocks.begin(), profile.blocks.end(),
                     [](const auto& a, const auto& b) { return a.total().seconds > b.total().seconds; });
  CHECK(sorted);
}

TEST_CASE("a part costs what is inside, and nothing itself") {
  const DiagramFolder folder;
  folder.write("inner.yaml",
               "stepwire: 1\ntitle: inner\ninputs:\n  u: {doc: signal}\noutputs:\n  y: lag\nblocks:\n"
               "  lag: {block: Lag, u: u, tau: 2 s}\n  twice: {block: Gain, u: lag, gain: 2}\n");
  folder.write("outer.yaml",
               "stepwire: 1\ntitle: outer\ninputs:\n  u: {doc: signal}\noutputs:\n  y: in.y\nblocks:\n"
               "  in: {diagram: inner.yaml, u: u}\n");
  folder.write("a.yaml",
               "stepwire: 1\ntitle: a\nstep: 1 s\nstop: 9 s\nsolver: rk4\nblocks:\n  t: {block: Clock}\n"
               "  rig: {diagram: outer.yaml, u: t}\nrecord: [rig.y]\n");
  double time = 0.0;
  const Profile profile = profile_plan(folder.plan("a.yaml"), {[&] { return time += 1e-6; }});
  for (const std::string name : {"rig", "rig.in"}) {
    const BlockCost& part = block(profile, name);
    CHECK(part.part);
    CHECK(part.self() == 0.0);
    CHECK(part.total().calls ==
          block(profile, "rig.in.lag").total().calls + block(profile, "rig.in.twice").total().calls);
  }
}

TEST_CASE("a profile ends where its run ends: at stop_when, at a value that is not finite") {
  const Profile stopped = profile_of(loop + "stop_when: a >= 12\n");
  CHECK(stopped.ticks == 12);
  CHECK(block(stopped, "a").phases[1].calls == 13);
  CHECK(block(stopped, "a").phases[3].calls == 12 * 4);
  const Profile failed = profile_of(
      "blocks:\n  x: {block: Integrator, u: up, initial: 1}\n  up: {block: Gain, gain: 1e100, u: x}\nstep: 1 "
      "s\nstop: 100 s\nsolver: euler\n");
  CHECK(failed.ticks < 10);
  CHECK(block(failed, "up").phases[1].calls == failed.ticks + 1);
}

}  // namespace stepwire::profile
