#include <catch2/catch.hpp>
#include <cmath>

#include "tests/support/run_text.hpp"

using namespace stepwire;

namespace {

constexpr double degree = M_PI / 180.0;

table::Table judged(const std::string& keys, const std::string& stop = "1 s", const std::string& more = "") {
  return run_text("step: 100 ms\nstop: " + stop + "\nblocks:\n" + more +
                  "  h: {block: HeadingPosterior, every: 100 ms, weber: 0.1, threshold: 0.04 N, forgetting: "
                  "0, "
                  "maximum: 6 N, free: 1 N, within: 30 deg, " +
                  keys + (keys.find("judged") == std::string::npos ? ", judged: 1" : "") +
                  "}\nrecord: [h.heading, h.deviation, h.sure]\n");
}

const std::string nothing = "direction: [0], precision: [0], ";

}  // namespace

TEST_CASE("Two cues are weighed by their precisions") {
  const table::Table run =
      judged("direction: [10 deg, 40 deg], precision: [200, 100], force: 0 N, push: 0, moving: 0");
  const double x = 200 * std::cos(10 * degree) + 100 * std::cos(40 * degree),
               y = 200 * std::sin(10 * degree) + 100 * std::sin(40 * degree);
  CHECK(column(run, "h.heading").back() == Approx(std::atan2(y, x)).margin(0.3 * degree));
  CHECK(column(run, "h.deviation").back() == Approx(1.0 / std::sqrt(std::hypot(x, y))).epsilon(0.05));
}

TEST_CASE("Without a cue all headings are alike, and the last is kept") {
  const table::Table run =
      judged(nothing + "force: 0 N, push: 0, moving: 0, initial: [100 deg, 0, 0], change: 2");
  CHECK(column(run, "h.sure").back() == Approx(60.0 / 360.0));
  CHECK(column(run, "h.heading").back() == Approx(100 * degree));
}

TEST_CASE("A resistance leaves both sides, and another push tells them apart") {
  // the path is at 70 degrees: a push along 40 degrees meets 6 sin 30, one along 10 degrees 6 sin 60
  const std::string pushes =
      "  a: {block: Step, time: 450 ms, before: 40 deg, after: 10 deg}\n"
      "  f: {block: Step, time: 450 ms, before: 3 N, after: 5.196 N}\n";
  const table::Table run = judged(nothing + "force: f, push: a, moving: 1", "1 s", pushes);
  CHECK(column(run, "h.sure")[4] == Approx(0.5).margin(0.05));
  CHECK(column(run, "h.heading").back() == Approx(70 * degree).margin(3 * degree));
  CHECK(column(run, "h.sure").back() > 0.95);
}

TEST_CASE(
    "A hand that is held and feels little knows nothing, one that is held against much knows it is wrong") {
  CHECK(column(judged(nothing + "force: 0.3 N, push: 0, moving: 0"), "h.sure").back() ==
        Approx(1.0 / 6.0).margin(0.01));
  const table::Table run = judged(nothing + "force: 5 N, push: 0, moving: 0");
  CHECK(std::abs(column(run, "h.heading").back()) > 50 * degree);
}

TEST_CASE("Between judgements nothing changes") {
  const table::Table run =
      judged("direction: [a], precision: [100], force: 0 N, push: 0, moving: 0, judged: now", "2 s",
             "  a: {block: Ramp, slope: 0.1}\n  now: {block: Pulse, period: 1 s, width: 0.1}\n");
  CHECK(column(run, "h.heading")[9] == column(run, "h.heading")[0]);
  CHECK(column(run, "h.heading")[10] != column(run, "h.heading")[9]);
}

TEST_CASE("Each direction has its own precision") {
  CHECK_THAT(
      error_of(
          "step: 1 s\nstop: 1 s\nrecord: [h.sure]\nblocks:\n  h: {block: HeadingPosterior, direction: [0, "
          "1], "
          "precision: [1], force: 0, push: 0, maximum: 0, free: 0, moving: 0, judged: 0, threshold: 1}\n"),
      Catch::Contains("1 number for 2 directions"));
}
