#include <catch2/catch.hpp>
#include <cmath>

#include "tests/support/run_text.hpp"

using namespace stepwire;

namespace {

constexpr double degree = M_PI / 180.0;

/// A hand that pushes where it was told last, in a map that resists by sin(angle off the way), which leads at
/// 0 degrees; first it pushes at 40.
Table search(const std::string& guess, const std::string& keys = "free: 0 N") {
  return run_text(
      "step: 0.3 s\nstop: 3 s\nblocks:\n  push: {block: UnitDelay, u: search.heading, initial: 40 deg}\n"
      "  off: {block: Trig, u: push}\n  size: {block: Abs, u: off}\n  felt: {block: Gain, u: size, gain: 8 "
      "N}\n"
      "  search: {block: ResistanceSearch, resistance: felt, maximum: 8 N, push: push, guess: " +
      guess + ", moving: 1, " + keys + "}\nrecord: [search.heading, search.precision, search.sense]\n");
}

}  // namespace

TEST_CASE("In the right sense the way is found at the first turn") {
  const Table run = search("0 deg");
  for (double heading : column(run, "search.heading")) REQUIRE(std::abs(heading) < 1e-12);
  CHECK(column(run, "search.sense").front() == -1.0);
}

TEST_CASE("In the wrong sense resistance grows, and it turns back") {
  const auto heading = column(search("90 deg"), "search.heading");
  CHECK(heading[0] == Approx(80.0 * degree));  // 40 degrees to the wrong side
  CHECK(std::abs(heading[1]) < 1e-12);         // and 80 back
}

TEST_CASE("What feels like a free motion gives no turn, and the way may lie within what it hides") {
  const Table run = search("0 deg", "free: 6 N");  // 8 N sin(40 degrees) is 5.14 N
  CHECK(column(run, "search.heading").front() == Approx(40.0 * degree));
  CHECK(column(run, "search.precision").front() == Approx(3.0 / std::pow(std::asin(6.0 / 8.0), 2)));
}

TEST_CASE("The heading is as certain as the force is felt") {
  // d asin(F/8)/dF = 1/(8 cos 40), and F errs by 7 % of 8 sin 40
  CHECK(column(search("0 deg", "weber: 0.07, free: 0 N"), "search.precision").front() ==
        Approx(1.0 / std::pow(0.07 * std::tan(40.0 * degree), 2)));
}

TEST_CASE("While the hand rests or nothing resists by intent, nothing is found") {
  const auto precision = [](const std::string& moving, const std::string& maximum) {
    return column(run_text("step: 0.3 s\nstop: 0.3 s\nblocks:\n  s: {block: ResistanceSearch, resistance: 3 "
                           "N, free: 0 N, maximum: " +
                           maximum + ", push: 0 deg, guess: 0 deg, moving: " + moving +
                           "}\nrecord: [s.precision]\n"),
                  "s.precision")
        .back();
  };
  CHECK(precision("0", "8 N") == 0.0);
  CHECK(precision("1", "0 N") == 0.0);
  CHECK(precision("1", "8 N") > 0.0);
}
