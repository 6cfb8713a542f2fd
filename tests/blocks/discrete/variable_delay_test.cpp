#include <catch2/catch.hpp>

#include "tests/support/run_text.hpp"

using namespace stepwire;

namespace {

/// 5 + t, late by what `delay` gives, every 10 ms.
std::vector<double> late(const std::string& delay, const std::string& keys = "") {
  return column(
      run_text("step: 10 ms\nstop: 1 s\nblocks:\n  u: {block: Ramp, initial: 5}\n  d: " + delay +
               "\n  y: {block: VariableDelay, u: u, delay: d, longest: 100 ms" + keys + "}\nrecord: [y]\n"),
      "y");
}

}  // namespace

TEST_CASE(
    "A signal comes late by the delay, between samples in a straight line, and before by its initial value") {
  const auto whole = late("{block: Constant, value: 30 ms}", ", initial: 7");
  const auto parts = late("{block: Constant, value: 37 ms}");
  for (std::size_t k = 0; k < whole.size(); ++k) {
    const double time = 0.01 * static_cast<double>(k);
    REQUIRE(whole[k] == Approx(k < 3 ? 7.0 : 5.0 + time - 0.03));
    if (k >= 4) REQUIRE(parts[k] == Approx(5.0 + time - 0.037));
  }
  CHECK(parts[3] == Approx(0.3 * 5.0));  // between the first sample and what was before
}

TEST_CASE("It is the same as Delay where the delay is whole and constant") {
  const table::Table run = run_text(R"(
step: 1 ms
stop: 1 s
blocks:
  u: {block: Noise, seed: 2}
  a: {block: Delay, u: u, delay: 20 ms, initial: 3}
  b: {block: VariableDelay, u: u, delay: 20 ms, longest: 50 ms, initial: 3}
record: [a, b]
)");
  CHECK(column(run, "a") == column(run, "b"));
}

TEST_CASE("The delay may change, and is held between one period and the longest") {
  const auto y = late("{block: Step, time: 0.5 s, before: 20 ms, after: 60 ms}");
  CHECK(y[40] == Approx(5.4 - 0.02));
  CHECK(y[80] == Approx(5.8 - 0.06));
  CHECK(late("{block: Constant, value: 0 s}") == late("{block: Constant, value: 10 ms}"));
  CHECK(late("{block: Constant, value: 1 s}") == late("{block: Constant, value: 100 ms}"));
}

TEST_CASE("Each element of a vector is delayed") {
  const table::Table run = run_text(
      "step: 1 ms\nstop: 9 ms\nblocks:\n  u: {block: Ramp, slope: [1, -2]}\n  y: {block: VariableDelay, u: "
      "u, delay: 3 "
      "ms, longest: 8 ms}\nrecord: [y]\n");
  CHECK(column(run, "y.1").back() == Approx(0.006));
  CHECK(column(run, "y.2").back() == Approx(-0.012));
}
