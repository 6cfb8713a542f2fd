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
        "output does not follow its input at once (a Lag, an Integrator, a UnitDelay), or have it solved at "
        "every "
        "instant: 'algebraic_loops: solve' in the head of the file");
}

TEST_CASE("of a block with several inputs the path names the ports of the loop") {
  const auto refused = faults_of(R"(blocks:
  t: {block: Clock}
  v: {block: Integrator, u: t, reset: t, value: bounce}
  bounce: {block: Gain, gain: -0.8, u: v}
solver: rk4
)");
  REQUIRE(refused.size() == 1);
  CHECK_THAT(refused[0], Catch::Contains("v.value -> v.y (test.yaml:3) -> bounce (test.yaml:4) -> v.value;"));
}

namespace {

/// How many numbers tear the loops of a diagram that is to be solved.
std::vector<std::size_t> tears_of(const std::string& blocks) {
  std::vector<std::size_t> tears;
  for (const SolvedLoop& loop : plan_text("blocks:\n" + blocks + "algebraic_loops: solve\n").loops)
    tears.push_back(loop.tears.size());
  return tears;
}

}  // namespace

TEST_CASE("a loop that is solved is torn at as few signals as can be") {
  // One cycle of three; two cycles that share a block; two that share none but feed each other both ways.
  CHECK(tears_of("  a: {block: Gain, u: c}\n  b: {block: Gain, u: a}\n  c: {block: Gain, u: b}\n") ==
        std::vector<std::size_t>{1});
  CHECK(tears_of("  a: {block: Sum, u: [b, c]}\n  b: {block: Gain, u: a}\n  c: {block: Gain, u: a}\n") ==
        std::vector<std::size_t>{1});
  CHECK(tears_of("  a: {block: Sum, u: [b, a]}\n  b: {block: Sum, u: [a, b]}\n") ==
        std::vector<std::size_t>{2});
  // Each of four blocks reads all others: without three of them none feeds itself.
  CHECK(tears_of("  a: {block: Sum, u: [b, c, d]}\n  b: {block: Sum, u: [a, c, d]}\n"
                 "  c: {block: Sum, u: [a, b, d]}\n  d: {block: Sum, u: [a, b, c]}\n") ==
        std::vector<std::size_t>{3});
  CHECK(tears_of("  a: {block: Gain, u: b}\n  b: {block: Gain, u: a}\n  c: {block: Gain, u: d}\n"
                 "  d: {block: Gain, u: c}\n") == std::vector<std::size_t>{1, 1});
}

TEST_CASE("a loop is torn at its guesses, and nowhere else where these are enough") {
  const Plan plan = plan_text(
      "blocks:\n  a: {block: Gain, u: c}\n  b: {block: InitialGuess, guess: 3, u: a}\n"
      "  c: {block: Gain, u: b}\nalgebraic_loops: solve\n");
  REQUIRE(plan.loops.size() == 1);
  REQUIRE(plan.loops[0].tears.size() == 1);
  CHECK(plan.diagram.blocks[static_cast<std::size_t>(plan.loops[0].tears[0].block)].name == "b");
  CHECK(tears_of("  a: {block: Sum, u: [b, c]}\n  b: {block: InitialGuess, guess: 1, u: a}\n"
                 "  c: {block: Gain, u: a}\n") == std::vector<std::size_t>{2});
}

TEST_CASE("of a loop's signals that with the fewest elements is torn") {
  const Plan plan = plan_text(R"(blocks:
  v: {block: Gain, gain: 0.1, u: three}
  three: {block: Mux, u: [n, 1, n]}
  n: {block: Norm, u: v}
algebraic_loops: solve
)");
  REQUIRE(plan.loops.size() == 1);
  REQUIRE(plan.loops[0].tears.size() == 1);
  CHECK(plan.diagram.blocks[static_cast<std::size_t>(plan.loops[0].tears[0].block)].name == "n");
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
