#include <catch2/catch.hpp>

#include "tests/support/plan_text.hpp"

namespace stepwire::plan {

TEST_CASE("an algebraic loop is refused with every hop, its line and the cure") {
  const auto refused = faults_of(R"(blocks:
  one:   {block: Constant, value: 1}
  error: {block: Sum, signs: "+-", u: [one, twice]}
  half:  {block: Gain, gain: 0.5, u: error}
  twice: {block: Gain, gain: 2, u: half}
)");
  REQUIRE(refused.size() == 1);
  CHECK(refused[0] ==
        "test.yaml:3:10: error: algebraic loop: each of these feeds the next at the same instant: error "
        "(test.yaml:3) -> half (test.yaml:4) -> twice (test.yaml:5) -> error; break it with a block whose "
        "output does "
        "not follow its input at once (a Lag, an Integrator, a UnitDelay)");
}

TEST_CASE("a block that feeds itself is a loop") {
  const auto refused = faults_of("blocks:\n  a: {block: Gain, u: a}\n");
  REQUIRE(refused.size() == 1);
  CHECK_THAT(refused[0], Catch::Contains("test.yaml:2:6: a: algebraic loop") &&
                             Catch::Contains(": a (test.yaml:2) -> a;"));
}

TEST_CASE("all loops that are independent of each other are reported") {
  const auto refused = faults_of(R"(blocks:
  a: {block: Gain, u: b}
  b: {block: Gain, u: a}
  x: {block: Integrator, u: y}
  y: {block: Gain, u: x}
  c: {block: Gain, u: d}
  d: {block: Gain, u: c}
solver: rk4
)");
  REQUIRE(refused.size() == 2);
  CHECK_THAT(refused[0], Catch::StartsWith("test.yaml:2:6: a:") &&
                             Catch::Contains("a (test.yaml:2) -> b (test.yaml:3) -> a;"));
  CHECK_THAT(refused[1], Catch::StartsWith("test.yaml:6:6: c:") &&
                             Catch::Contains("c (test.yaml:6) -> d (test.yaml:7) -> c;"));
}

TEST_CASE("a loop through parts names the blocks inside, each in its own file") {
  const DiagramFolder folder;
  folder.write(
      "double.yaml",
      "stepwire: 1\ninputs: {u: {}}\noutputs: {y: twice}\nblocks:\n  twice: {block: Gain, gain: 2, u: u}\n");
  folder.write("main.yaml",
               "stepwire: 1\nstep: 1 s\nstop: 1 s\nblocks:\n  first: {diagram: double.yaml, u: second}\n"
               "  second: {diagram: double.yaml, u: first}\n");
  const auto refused = folder.faults("main.yaml");
  REQUIRE(refused.size() == 1);
  CHECK_THAT(
      refused[0],
      Catch::StartsWith("double.yaml:5:10: first.twice: algebraic loop") &&
          Catch::Contains("first.twice (double.yaml:5) -> second.twice (double.yaml:5) -> first.twice;") &&
          Catch::Contains("(used by main.yaml:5:20)"));
}

}  // namespace stepwire::plan
