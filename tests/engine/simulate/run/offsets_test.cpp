#include <catch2/catch.hpp>
#include <cmath>

#include "tests/support/plan_text.hpp"
#include "tests/support/run_text.hpp"

namespace stepwire::run {

namespace {

std::string text(const std::string& blocks, const std::string& record) {
  return "step: 1 ms\nstop: 20 ms\nsolver: rk4\nblocks:\n" + blocks + "record: " + record + "\n";
}

std::vector<double> recorded(const std::string& blocks, const std::string& name) {
  return column(run_text(text(blocks, "[" + name + "]")), name);
}

}  // namespace

TEST_CASE("a block with an offset first runs there, and then once a period") {
  const std::vector<double> held = recorded(
      "  t: {block: Clock}\n  y: {block: ZeroOrderHold, u: t, every: {period: 3 ms, offset: 1 ms}}\n", "y");
  for (int tick = 0; tick <= 20; ++tick) {
    const int sampled = tick < 1 ? 0 : tick - (tick - 1) % 3;
    CHECK(held[static_cast<std::size_t>(tick)] == Approx(1e-3 * sampled).margin(1e-15));
  }
}

TEST_CASE("before its first run an output is the initial state, or 0 where it follows from inputs") {
  const std::string every = "every: {period: 4 ms, offset: 2 ms}";
  CHECK(recorded("  y: {block: UnitDelay, u: 1, initial: 5, " + every + "}\n", "y")[0] == 5.0);
  const std::vector<double> delayed =
      recorded("  y: {block: UnitDelay, u: 1, initial: 5, " + every + "}\n", "y");
  CHECK(delayed[5] == 5.0);  // the first run takes in 1, the next one shows it
  CHECK(delayed[6] == 1.0);
  const std::vector<double> gain = recorded(
      "  t: {block: Clock}\n  s: {block: Sum, u: [t, 1]}\n  y: {block: Gain, u: s, gain: 2, " + every + "}\n",
      "y");
  CHECK(gain[1] == 0.0);
  CHECK(gain[2] == Approx(2.004));
}

TEST_CASE("what is fed by two blocks of one period and two offsets runs at both") {
  const std::vector<double> sum = recorded(
      "  t: {block: Clock}\n"
      "  a: {block: ZeroOrderHold, u: t, every: 4 ms}\n"
      "  b: {block: ZeroOrderHold, u: t, every: {period: 4 ms, offset: 2 ms}}\n"
      "  y: {block: Sum, u: [a, b]}\n",
      "y");
  CHECK(sum[3] == Approx(0.0 + 2e-3));
  CHECK(sum[4] == Approx(4e-3 + 2e-3));
  CHECK(sum[6] == Approx(4e-3 + 6e-3));
}

TEST_CASE("a sampled integrator adds its period at each run, wherever these lie") {
  const std::vector<double> sum =
      recorded("  y: {block: DiscreteIntegrator, u: 2, every: {period: 5 ms, offset: 3 ms}}\n", "y");
  CHECK(sum[7] == Approx(0.0).margin(1e-15));
  CHECK(sum[8] == Approx(2.0 * 5e-3));
  CHECK(sum[18] == Approx(2.0 * 15e-3));
}

TEST_CASE("times inside a part count from the first run of the part") {
  const DiagramFolder folder;
  folder.write("part.yaml",
               "stepwire: 1\ntitle: part\ninputs:\n  u: {unit: s}\noutputs:\n  y: y\n  slow: slow\nblocks:\n"
               "  y: {block: ZeroOrderHold, u: u}\n"
               "  slow: {block: ZeroOrderHold, u: u, every: {period: 4 ms, offset: 2 ms}}\n");
  folder.write(
      "main.yaml",
      "stepwire: 1\ntitle: main\nstep: 1 ms\nstop: 12 ms\nblocks:\n  t: {block: Clock}\n"
      "  p: {diagram: part.yaml, u: t, every: {period: 2 ms, offset: 1 ms}}\nrecord: [p.y, p.slow]\n");
  const table::Table run = folder.run("main.yaml");
  CHECK(column(run, "p.y")[4] == Approx(3e-3));
  CHECK(column(run, "p.slow")[2] == 0.0);
  CHECK(column(run, "p.slow")[6] == Approx(3e-3));
  CHECK(column(run, "p.slow")[7] == Approx(7e-3));
}

TEST_CASE("an offset is at least 0 and below the period, and both are multiples of the step") {
  const auto fault = [](const std::string& every) {
    return faults_of(text("  y: {block: UnitDelay, u: 1, every: " + every + "}\n", "[y]")).front();
  };
  CHECK_THAT(fault("{period: 3 ms, offset: 3 ms}"),
             Catch::Contains("0.003 s is not below the period of 0.003 s"));
  CHECK_THAT(fault("{period: 3 ms, offset: -1 ms}"), Catch::Contains("must be 0 or more"));
  CHECK_THAT(fault("{period: 3 ms, offset: 0.5 ms}"), Catch::Contains("not a whole multiple of the step"));
  CHECK_THAT(fault("{offset: 1 ms}"), Catch::Contains("'period' is missing"));
  CHECK_THAT(fault("{period: 3 ms, ofset: 1 ms}"), Catch::Contains("offset"));
}

}  // namespace stepwire::run
