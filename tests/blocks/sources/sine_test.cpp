#include <catch2/catch.hpp>
#include <numbers>

#include "engine/base/math/elementary.hpp"
#include "tests/support/run_text.hpp"

using namespace stepwire;

TEST_CASE("a sine of half a hertz is sin(pi t + phase) to the last bit") {
  const table::Table run = run_text(R"(
step: 1 ms
stop: 3 s
blocks:
  hand: {block: Sine, amplitude: 2, frequency: 0.5 Hz, phase: 0.3, bias: -1}
record: [hand]
)");
  const auto &time = column(run, "time"), &hand = column(run, "hand");
  REQUIRE(hand.size() == 3001);
  for (std::size_t i = 0; i < hand.size(); ++i)
    REQUIRE(hand[i] == 2.0 * fn::sin(std::numbers::pi * time[i] + 0.3) + -1.0);
}

TEST_CASE("a sine with lists is one wave for each element") {
  const table::Table run = run_text(R"(
step: 10 ms
stop: 1 s
blocks:
  waves: {block: Sine, frequency: 2, phase: [0 deg, 90 deg]}
  circle: {block: Norm, u: waves}
record: [circle]
)");
  for (double radius : column(run, "circle")) REQUIRE(radius == Approx(1.0).epsilon(1e-14));
}
