#include <catch2/catch.hpp>
#include <cmath>

#include "tests/support/run_text.hpp"

using namespace stepwire;

TEST_CASE("A lag answers a step with an exponential") {
  const table::Table table = run_text(R"(
step: 1 ms
stop: 2 s
solver: rk4
blocks:
  lag: {block: Lag, u: 3, tau: 0.4 s, gain: 2, initial: 1}
record: [lag]
)");
  const auto& time = column(table, "time");
  for (std::size_t k = 0; k < time.size(); ++k)
    CHECK(column(table, "lag")[k] == Approx(6.0 - 5.0 * std::exp(-time[k] / 0.4)).epsilon(1e-10));
}

TEST_CASE("A lag has a time constant for each element and the unit of gain and input") {
  const table::Table table = run_text(R"(
step: 1 ms
stop: 1 s
solver: rk4
blocks:
  lag: {block: Lag, u: {value: [1, 1], unit: mm}, tau: [0.5, 0.25], gain: 2 N/mm}
record: [lag]
)");
  CHECK(column(table, "lag.1").back() == Approx(2.0 * (1.0 - std::exp(-2.0))));
  CHECK(column(table, "lag.2").back() == Approx(2.0 * (1.0 - std::exp(-4.0))));
  CHECK(table.find("lag.1")->unit == "N");
}

TEST_CASE("A time constant that is not above zero is refused") {
  CHECK_THAT(error_of(R"(
step: 1 ms
stop: 1 s
solver: rk4
blocks:
  lag: {block: Lag, u: 1, tau: 0 s}
)"),
             Catch::Contains("lag.tau: 0 s is not allowed; it must be above 0"));
}
