#include <catch2/catch.hpp>
#include <cmath>

#include "blocks/register.hpp"
#include "tests/support/plan_text.hpp"
#include "tests/support/run_text.hpp"

namespace stepwire::plan {

namespace {

/// Two outputs of one block: z is a state, force follows the velocity at once. z' = v - z, force = 2 v + z.
struct Damper {
  Input<1> v{};
  Output<1> force{}, z{};
  State<1> x{};

  void outputs() {
    force = 2.0 * v + x;
    z = x;
  }
  void derivatives() { x.derivative = v - x; }
  void configure(Configure& is) { is.feedthrough<&Damper::v, &Damper::z>(false); }

  static void declare(Declare<Damper>& is) {
    is.block("Damper", {.doc = "a test"});
    is.input<&Damper::v>({.doc = "velocity"});
    is.output<&Damper::force>({.doc = "force"});
    is.output<&Damper::z>({.doc = "state"});
    is.state<&Damper::x>({.doc = "state"});
  }
};

Registry with_damper() {
  Registry registry = blocks();
  registry.add<Damper>("test");
  return registry;
}

}  // namespace

TEST_CASE("a part of which one output feeds back into its other input runs") {
  const DiagramFolder folder;
  folder.write("two.yaml", R"(stepwire: 1
inputs: {a: {}, b: {}}
outputs: {y: plus_one, z: minus}
blocks:
  plus_one: {block: Sum, u: [a, 1]}
  minus: {block: Gain, gain: -1, u: b}
)");
  folder.write("main.yaml", R"(stepwire: 1
step: 1 s
stop: 3 s
blocks:
  t: {block: Clock}
  two: {diagram: two.yaml, a: t, b: two.y}
record: [two.y, two.z]
)");
  const table::Table run = folder.run("main.yaml");
  CHECK(column(run, "two.y") == std::vector<double>{1, 2, 3, 4});
  CHECK(column(run, "two.z") == std::vector<double>{-1, -2, -3, -4});
}

TEST_CASE(
    "a block with one output of its state and one that follows its input runs in a feedback over both") {
  static const Registry registry = with_damper();
  // v = 1 - z, so x' = 1 - 2 x and x = (1 - exp(-2 t)) / 2; force = 2 - 2 x + x.
  const run::RunResult result = result_of(R"(blocks:
  v: {block: Sum, signs: "+-", u: [1, damper.z]}
  damper: {block: Damper, v: v}
step: 1 ms
stop: 1 s
solver: rk4
record: [v, damper.force, damper.z]
)",
                                          {}, registry);
  const table::Table& run = result.recordings.front().table;
  const auto& time = column(run, "time");
  for (std::size_t row = 0; row < time.size(); row += 50) {
    const double x = (1.0 - std::exp(-2.0 * time[row])) / 2.0;
    CHECK(column(run, "damper.z")[row] == Approx(x).margin(1e-12));
    CHECK(column(run, "v")[row] == Approx(1.0 - x).epsilon(1e-12));
    CHECK(column(run, "damper.force")[row] == Approx(2.0 - x).epsilon(1e-12));
  }
}

TEST_CASE("the output that follows the input at once still makes a loop") {
  static const Registry registry = with_damper();
  const auto refused = faults_of(
      "solver: rk4\nblocks:\n  v: {block: Sum, u: [1, damper.force]}\n  damper: {block: Damper, v: v}\n", {},
      registry);
  REQUIRE(refused.size() == 1);
  CHECK_THAT(refused[0], Catch::Contains("v (test.yaml:3) -> damper.force (test.yaml:4) -> v;"));
}

TEST_CASE("a mass that a damper brakes by its own velocity comes to the speed at which the forces balance") {
  // The force of the damper follows the velocity at once, but the velocity is a state: no loop.
  const table::Table run = run_text(R"(
step: 0.1 ms
stop: 1 s
solver: rk4
blocks:
  damper: {block: MRDamper, preset: rd-1097-01, velocity: mass.velocity, current: 0.1 A}
  net: {block: Sum, signs: "+-", u: [100 N, damper.force]}
  mass: {block: Mass, mass: 1 kg, force: net}
record: [mass.velocity, damper.force]
)");
  CHECK(column(run, "damper.force").back() == Approx(100.0).epsilon(1e-6));
  CHECK(column(run, "mass.velocity").back() > 0.0);
}

TEST_CASE("parts that are gains only may stand in series without any lag") {
  const DiagramFolder folder;
  folder.write(
      "double.yaml",
      "stepwire: 1\ninputs: {u: {}}\noutputs: {y: twice}\nblocks:\n  twice: {block: Gain, gain: 2, u: u}\n");
  folder.write("main.yaml", R"(stepwire: 1
step: 1 s
stop: 3 s
blocks:
  d: {diagram: double.yaml, u: c}
  c: {diagram: double.yaml, u: b}
  b: {diagram: double.yaml, u: a}
  a: {diagram: double.yaml, u: t}
  t: {block: Clock}
record: [a, b.y, c, d]
)");
  const table::Table run = folder.run("main.yaml");
  CHECK(column(run, "a") == std::vector<double>{0, 2, 4, 6});
  CHECK(column(run, "b.y") == std::vector<double>{0, 4, 8, 12});
  CHECK(column(run, "d") == std::vector<double>{0, 16, 32, 48});
}

TEST_CASE("parts stand in parts, three deep, with parameters handed down") {
  const DiagramFolder folder;
  folder.write("inner/gain.yaml",
               "stepwire: 1\nparameters: {k: 1}\ninputs: {u: {}}\noutputs: {y: g}\nblocks:\n  g: {block: "
               "Gain, gain: $k, u: u}\n");
  folder.write("middle.yaml", R"(stepwire: 1
parameters: {k: 1}
inputs: {u: {}}
outputs: {y: second.y, first: first}
blocks:
  first: {diagram: inner/gain.yaml, k: $k, u: u}
  second: {diagram: inner/gain.yaml, k: = k + 1, u: first}
)");
  folder.write("outer.yaml",
               "stepwire: 1\nparameters: {k: 5}\ninputs: {u: {}}\noutputs: {y: m.y}\nblocks:\n  m: {diagram: "
               "middle.yaml, k: $k, u: u}\n");
  folder.write("main.yaml", R"(stepwire: 1
step: 1 s
stop: 2 s
blocks:
  t: {block: Clock}
  plain: {diagram: outer.yaml, u: t}
  set: {diagram: outer.yaml, u: t, k: 2}
record: [plain, set, set.m.first.g, set.m.first]
)");
  const table::Table run = folder.run("main.yaml", {{"plain.m.second.k", "10"}});
  CHECK(column(run, "plain") == std::vector<double>{0, 50, 100});
  CHECK(column(run, "set") == std::vector<double>{0, 6, 12});
  CHECK(column(run, "set.m.first.g") == std::vector<double>{0, 2, 4});
  CHECK(column(run, "set.m.first") == std::vector<double>{0, 2, 4});
}

}  // namespace stepwire::plan
