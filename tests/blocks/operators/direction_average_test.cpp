#include <catch2/catch.hpp>
#include <cmath>

#include "tests/support/run_text.hpp"

using namespace stepwire;

namespace {

table::Table looked(const std::string& keys, const std::string& stop = "10 s") {
  return run_text("step: 100 ms\nstop: " + stop +
                  "\nblocks:\n  a: {block: DirectionAverage, every: 100 ms, " + keys +
                  "}\nrecord: [a.y, a.precision]\n");
}

}  // namespace

TEST_CASE("What each look has of its own averages out, what all share does not") {
  const table::Table run = looked("direction: 1, noise: 0.3, bias: 0.1");
  const auto& precision = column(run, "a.precision");
  for (std::size_t k = 0; k < precision.size(); ++k)
    REQUIRE(1.0 / precision[k] == Approx(0.01 + 0.09 / static_cast<double>(k + 1)));
  CHECK(column(run, "a.y").back() == Approx(1.0));
}

TEST_CASE("With forgetting as many looks count as (2 - f)/f") {
  const table::Table run = looked("direction: 1, noise: 0.3, bias: 0.1, forgetting: 0.1", "60 s");
  CHECK(1.0 / column(run, "a.precision").back() == Approx(0.01 + 0.09 / 19.0));
}

TEST_CASE("The mean is that of directions, not of numbers") {
  const table::Table run = run_text(R"(
step: 100 ms
stop: 100 ms
blocks:
  d: {block: Step, time: 50 ms, before: 3.04159265, after: -3.04159265}
  a: {block: DirectionAverage, direction: d, noise: 0.3, every: 100 ms}
record: [a.y]
)");
  CHECK(std::abs(column(run, "a.y").back()) == Approx(M_PI).epsilon(1e-6));
}

TEST_CASE("Without a look nothing is known") {
  CHECK(column(looked("direction: 1, shown: 0, noise: 0.3"), "a.precision").back() == 0.0);
}
