// Notes on resets that are true at the end and do not act again.
#include <catch2/catch.hpp>

#include "tests/support/plan_text.hpp"
#include "tests/support/run_text.hpp"

namespace stepwire::run {

namespace {

/// Drops a ball on a floor at 0 and keeps this part of its speed at each bounce.
run::RunResult dropped(const std::string& kept, const std::string& head) {
  return result_of("step: 10 ms\nstop: 5 s\nsolver: rk4\n" + head +
                   "blocks:\n  v: {block: Integrator, u: -9.81, reset: hit, value: bounce}\n"
                   "  x: {block: Integrator, u: v, initial: 1}\n"
                   "  hit: {block: Compare, u: x, operator: less, to: 0}\n"
                   "  bounce: {block: Gain, gain: " +
                   kept + ", u: v.before}\nrecord: [x]\n");
}

}  // namespace

TEST_CASE("a ball that falls through its floor, since its reset acts once between ticks, is noted") {
  const RunResult fallen = dropped("-0.5", "");
  REQUIRE(column(fallen.recordings.front().table, "x").back() < -1.0);
  REQUIRE(fallen.diagnostics.size() == 1);
  CHECK(fallen.diagnostics[0].block == "v");
  CHECK_THAT(fallen.diagnostics[0].text, Catch::Contains("'events: locate'"));
}

TEST_CASE("a ball that bounces has no note") {
  const RunResult thrown = dropped("-1", "events: locate\n");
  REQUIRE(column(thrown.recordings.front().table, "x").back() >= 0.0);
  CHECK(thrown.diagnostics.empty());
}

TEST_CASE("a reset by time that stays true has no note") {
  const RunResult result = result_of(
      "step: 10 ms\nstop: 1 s\nsolver: rk4\nblocks:\n  t: {block: Clock}\n  late: {block: Compare, u: t, operator: "
      "greater, "
      "to: 0.5 s}\n  x: {block: Integrator, u: 1, reset: late}\nrecord: [x]\n");
  CHECK(result.diagnostics.empty());
}

}  // namespace stepwire::run
