#include <algorithm>
#include <catch2/catch.hpp>
#include <set>

#include "tests/support/plan_text.hpp"
#include "tests/support/run_text.hpp"

namespace stepwire::plan {

namespace {

const std::string frame =
    "step: 1 s\nstop: 2 s\nblocks:\n  t: {block: Clock}\n  v: {block: Constant, value: [1, 2, 3]}\n";

std::string only_fault(const std::string& blocks) {
  const auto refused = faults_of(
      "blocks:\n  v: {block: Constant, value: [1, 2, 3]}\n  w: {block: Constant, value: [1, 2]}\n" + blocks);
  REQUIRE(refused.size() == 1);
  return refused[0];
}

}  // namespace

TEST_CASE("vectors pass gains, and a single gain counts for every element") {
  const table::Table run = run_text(
      frame +
      "  g: {block: Gain, gain: 10, u: v}\n  h: {block: Gain, gain: [1, 10, 100], u: g}\nrecord: [g, h]\n");
  CHECK(column(run, "g.3") == std::vector<double>{30, 30, 30});
  CHECK(column(run, "h.1") == std::vector<double>{10, 10, 10});
  CHECK(column(run, "h.3") == std::vector<double>{3000, 3000, 3000});
}

TEST_CASE("a sum adds a single signal to every element of a vector") {
  const table::Table run =
      run_text(frame + "  s: {block: Sum, signs: \"+-+\", u: [v, t, 10]}\nrecord: [s]\n");
  CHECK(column(run, "s.1") == std::vector<double>{11, 10, 9});
  CHECK(column(run, "s.3") == std::vector<double>{13, 12, 11});
}

TEST_CASE("a number at a vector input stands for all of its elements") {
  const table::Table run = run_text(
      "step: 1 s\nstop: 2 s\nsolver: euler\nblocks:\n  x: {block: Integrator, u: 2, initial: [0, "
      "10]}\nrecord: [x]\n");
  CHECK(column(run, "x.1") == std::vector<double>{0, 2, 4});
  CHECK(column(run, "x.2") == std::vector<double>{10, 12, 14});
}

TEST_CASE("a vector goes round a loop: its size comes from the one place that says it") {
  const table::Table run = run_text(R"(
step: 1 s
stop: 3 s
blocks:
  next: {block: Sum, u: [last, step]}
  last: {block: UnitDelay, u: next}
  step: {block: Constant, value: [1, 10]}
record: [next]
)");
  CHECK(column(run, "next.1") == std::vector<double>{1, 2, 3, 4});
  CHECK(column(run, "next.2") == std::vector<double>{10, 20, 30, 40});
}

TEST_CASE("a loop takes its size from whichever element of a list is known, and the others are held to it") {
  const auto refused = faults_of(R"(blocks:
  three: {block: Sum, u: [v, last]}
  last: {block: UnitDelay, u: pair}
  pair: {block: Sum, u: [last, w]}
  v: {block: Constant, value: [1, 2, 3]}
  w: {block: Constant, value: [1, 2]}
)");
  REQUIRE(refused.size() == 1);
  CHECK(refused[0] ==
        "test.yaml:2:30: three.u: 'last' has 2 elements, but others in this list have 3; all must have the "
        "same, or one");
}

TEST_CASE("an initial value gives a loop its size") {
  const table::Table run = run_text(
      "step: 1 s\nstop: 2 s\nblocks:\n  twice: {block: Gain, gain: 2, u: last}\n"
      "  last: {block: UnitDelay, u: twice, initial: [1, 3]}\nrecord: [last]\n");
  CHECK(column(run, "last.1") == std::vector<double>{1, 2, 4});
  CHECK(column(run, "last.2") == std::vector<double>{3, 6, 12});
}

TEST_CASE("what nothing gives a size is a single number") {
  const table::Table run = run_text(
      "step: 1 s\nstop: 2 s\nblocks:\n  a: {block: Sum, u: [b, 1]}\n  b: {block: UnitDelay, u: a}\nrecord: "
      "[a]\n");
  CHECK(column(run, "a") == std::vector<double>{1, 2, 3});
}

TEST_CASE("sizes that differ are refused where the wire ends, with both ends") {
  CHECK(only_fault("  g: {block: Gain, gain: [1, 2], u: v}\n") ==
        "test.yaml:4:37: g.u: 'v' has 3 elements, but g.u takes 2; join or pick elements with Mux or Select");
  CHECK(only_fault("  s: {block: Sum, u: [v, w, 1]}\n") ==
        "test.yaml:4:26: s.u: 'w' has 2 elements, but others in this list have 3; all must have the same, or "
        "one");
  CHECK(only_fault("  m: {block: MatrixGain, gain: [[1, 2], [3, 4]], u: v}\n") ==
        "test.yaml:4:53: m.u: 'v' has 3 elements, but m.u takes 2; join or pick elements with Mux or Select");
  CHECK(only_fault("  g: {block: Gain, gain: [1, 2], u: [1, 2, 3]}\n") ==
        "test.yaml:4:37: g.u: has 3 numbers; 2 would fit");
  CHECK_THAT(only_fault("  d: {block: UnitDelay, u: v, initial: [1, 2]}\n"),
             Catch::StartsWith("test.yaml:4:28: d.u: 'v' has 3 elements, but d.u takes 2"));
}

TEST_CASE("sizes that only a product of one determines are found in any order of the blocks") {
  // n2 = 0.5 * 0.5; n3 = [n2, 0.5]; n6 has its numbers below each other
  std::vector<std::string> lines{
      "  n2: {block: MatrixMultiply, a: 0.5, b: 0.5}\n", "  n3: {block: Concatenate, u: [n2, 0.5]}\n",
      "  n4: {block: Concatenate, u: [n3]}\n", "  n6: {block: Reshape, u: n4, rows: 2}\n"};
  do {
    std::string text = "step: 1 s\nstop: 1 s\nblocks:\n";
    for (const std::string& line : lines) text += line;
    INFO(text);
    const table::Table run = run_text(text + "record: [n6]\n");
    CHECK(column(run, "n6.1") == std::vector<double>{0.25, 0.25});
    CHECK(column(run, "n6.2") == std::vector<double>{0.5, 0.5});
  } while (std::ranges::next_permutation(lines).found);
}

TEST_CASE("rows and columns that nothing determines are assumed alike in any order of the blocks") {
  std::vector<std::string> lines{"  n1: {block: Sine}\n", "  n2: {block: MatrixMultiply, a: n1, b: n1}\n",
                                 "  n3: {block: Concatenate, u: [n2, n1]}\n",
                                 "  n4: {block: Concatenate, u: [n3]}\n",
                                 "  n6: {block: Reshape, u: n4, rows: 2}\n"};
  std::set<std::string> outcomes;
  do {
    std::string text = "blocks:\n";
    for (const std::string& line : lines) text += line;
    std::string outcome;
    for (const std::string& fault : faults_of(text)) outcome += fault.substr(fault.find(": ")) + "\n";
    outcomes.insert(outcome);
  } while (std::ranges::next_permutation(lines).found);
  CHECK(outcomes.size() == 1);
}

TEST_CASE("rows of different length are no matrix") {
  CHECK(only_fault("  m: {block: MatrixGain, gain: [[1, 2], [3]], u: w}\n") ==
        "test.yaml:4:41: m.gain: this row has 1 number, the first has 2");
}

}  // namespace stepwire::plan
