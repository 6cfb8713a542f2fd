#include <catch2/catch.hpp>
#include <numeric>

#include "tests/support/run_text.hpp"

using namespace stepwire;

TEST_CASE("pulses are high in the first part of each period after the delay") {
  const table::Table run = run_text(R"(
step: 0.1 s
stop: 1.2 s
blocks:
  y: {block: Pulse, amplitude: 2, period: 0.5 s, width: 40 %, delay: 0.2 s, bias: -1}
record: [y]
)");
  REQUIRE(column(run, "y") == std::vector<double>{-1, -1, 1, 1, -1, -1, -1, 1, 1, -1, -1, -1, 1});
}

TEST_CASE("edges of pulses fall on their ticks through a long run") {
  const table::Table run = run_text(R"(
step: 1 ms
stop: 99.999 s
blocks:
  y: {block: Pulse, period: 7 ms, width: 0.42857142857142855}
record: [y]
)");
  const auto& y = column(run, "y");
  for (std::size_t i = 0; i < y.size(); ++i) REQUIRE(y[i] == (i % 7 < 3 ? 1.0 : 0.0));
}

TEST_CASE("a pulse as wide as its period never falls, and one without width never rises") {
  const table::Table run = run_text(R"(
step: 0.1 s
stop: 3 s
blocks:
  wide: {block: Pulse, period: 0.3 s, width: 1}
  none: {block: Pulse, period: 0.3 s, width: 0}
record: [wide, none]
)");
  REQUIRE(column(run, "wide") == std::vector<double>(31, 1.0));
  REQUIRE(column(run, "none") == std::vector<double>(31, 0.0));
}
