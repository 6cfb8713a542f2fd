#include <catch2/catch.hpp>

#include "tests/engine/view/plot/samples.hpp"

namespace stepwire::claim {
using namespace testing;

namespace {

std::string check_of(const std::string& text) {
  const auto read = claims_of("- {that: a, " + text + "}");
  REQUIRE(read.faults.empty());
  return read.claims.at(0).check;
}

std::string faults_of(const std::string& text) {
  return claims_of("- " + text).faults;
}

}  // namespace

TEST_CASE("the condition of a claim is told as text") {
  CHECK(check_of("max: abs(rig.x), at_most: 2 mm, where: rig.x > -4 mm && time > 1") ==
        "max abs(rig.x) <= 2 mm where rig.x > -4 mm && time > 1");
  CHECK(check_of("final: rig.x, equals: 2/3, within: 1e-3") == "final rig.x = 2/3 within 1e-3 m");
  CHECK(check_of("final: rig.x, equals: 2") == "final rig.x = 2 m");
  CHECK(check_of("max: current, at_most: = 2*$limit") == "max current <= 2*$limit");
  CHECK(check_of("final: rig.x/rig.x, equals: 2") == "final rig.x/rig.x = 2");
  CHECK(check_of("max: rig.x, between: [1, 2 m]") == "max rig.x between 1 m and 2 m");
  CHECK(check_of("at: {time: 2 s, value: rig.x}, between: [1 mm, 2 mm]") ==
        "rig.x at 2 s between 1 mm and 2 mm");
  CHECK(check_of("rising: {value: rig.x, over: time}, at_least: 0.9") == "rising rig.x over time >= 0.9");
  CHECK(check_of("quantile: {share: 5 %, value: rig.x}, at_most: 1 mm") == "5 % quantile of rig.x <= 1 mm");
  CHECK(check_of("fit: [push.force, 3 + 9*rig.x], at_least: 88 %") ==
        "fit push.force to 3 + 9*rig.x >= 88 %");
}

TEST_CASE("numbers of a claim become SI, with parameters and expressions") {
  const auto read = claims_of(
      "- {that: a, max: rig.x, equals: 2 mm, within: 10 %}\n"
      "- {that: b, max: current, at_most: 2*$limit}\n"
      "- {that: c, max: current, at_least: $low}\n"
      "- {that: d, fit: [rig.x, rig.x], at_least: 88 %}\n"
      "- {that: e, fraction: rig.x > 0, at_least: 88 %}\n");
  REQUIRE(read.faults.empty());
  CHECK(read.claims[0].comparison.low == 2e-3);
  CHECK(read.claims[0].comparison.within == Approx(2e-4));
  CHECK(read.claims[1].comparison.low == 0.7);
  CHECK(read.claims[2].comparison.low == -2.0);
  CHECK(read.claims[3].comparison.low == 88.0);
  CHECK(read.claims[4].comparison.low == 0.88);
}

TEST_CASE("an unknown name is told with its place inside the expression and the nearest name") {
  CHECK(faults_of("{that: a, max: abs(rig.xx), at_most: 2}") ==
        "d.yaml:1:22: claims.max: 'rig.xx' is not recorded; did you mean 'rig.x'? Recorded are: time, "
        "current, rig.x, "
        "rig.v, push.force, slow\n");
  CHECK(faults_of("{that: a, max: \"$limt * rig.x\", at_most: 2}") ==
        "d.yaml:1:19: claims.max: there is no parameter 'limt'; did you mean 'limit'? There are: limit, low, "
        "reach\n");
}

TEST_CASE("a number of the wrong kind is refused") {
  CHECK(faults_of("{that: a, max: rig.x, at_most: 2 N}") ==
        "d.yaml:1:34: claims.at_most: 2 N is in N, but the claim's value is in m; write it in m\n");
  CHECK(faults_of("{that: a, fraction: rig.x > 0, at_most: 2 N}") ==
        "d.yaml:1:43: claims.at_most: 2 N is in N, but the claim's value has no unit; write a number without "
        "unit\n");
  CHECK(faults_of("{that: a, max: rig.x, equals: 2 mm, within: 1 deg}") ==
        "d.yaml:1:47: claims.within: 1 deg is in deg, but the claim's value is in m; write it in m\n");
  CHECK(faults_of("{that: a, max: rig.x, equals: 2 mm, within: 1 foo}") ==
        "d.yaml:1:47: claims.within: 'foo' is no unit\n");
  CHECK(faults_of("{that: a, at: {time: 3 mm, value: rig.x}, at_most: 2 mm}") ==
        "d.yaml:1:24: claims.at.time: 3 mm is in m, but a time is in s; write it in s\n");
  CHECK(faults_of("{that: a, fit: [rig.x, push.force], at_least: 80}") ==
        "d.yaml:1:18: claims.fit: 'rig.x' is in m, but 'push.force' is in N\n");
  CHECK(faults_of("{that: a, max: rig.x, at_most: time}") ==
        "d.yaml:1:34: claims.at_most: a number is wanted here, but 'time' is a recorded column\n");
}

TEST_CASE("a claim has one reduction, one comparison and a text") {
  CHECK(faults_of("{that: a, max: time, min: time, at_most: 2}") ==
        "d.yaml:1:24: claims: both 'max' and 'min'; a claim has one reduction\n");
  CHECK(faults_of("{that: a, max: time}") ==
        "d.yaml:1:3: claims: a claim needs one comparison: equals, at_most, at_least, between\n");
  CHECK(faults_of("{max: time, at_most: 1}") ==
        "d.yaml:1:3: claims: 'that' is missing (the statement, for people): {that: ..., final: ..., equals: "
        "...}\n");
  CHECK(faults_of("{that: a, max: time, at_most: 1, within: 2}") ==
        "d.yaml:1:44: claims.within: 'within' goes with 'equals', 'like' only\n");
  CHECK(faults_of("{that: a, max: time, between: [2, 1]}") ==
        "d.yaml:1:33: claims.between: 2 is above 1; the smaller number comes first\n");
}

TEST_CASE("columns that were recorded apart do not meet in one claim") {
  CHECK(faults_of("{that: a, max: rig.x, where: slow > 3, at_most: 1}") ==
        "d.yaml:1:3: claims.max: 'rig.x' and 'slow' are recorded at different periods; record them in one "
        "entry to use "
        "them together\n");
}

TEST_CASE("a key that is a piece of an expression is told to be quoted") {
  CHECK_THAT(
      faults_of("{that: a, max: min(rig.x, 3), at_most: 1}"),
      Catch::Contains("d.yaml:1:29: claims: a claim has no '3)'; it looks like a piece of an expression"));
  CHECK_THAT(faults_of("{that: more damping, less overshoot, max: rig.x, at_most: 1}"),
             Catch::Contains("a claim has no 'less overshoot'; it looks like a piece of a sentence"));
}

TEST_CASE("all faults of all claims are found in one pass") {
  const auto read =
      claims_of("- {that: a, maxx: time, at_most: 2}\n- 3\n- {that: b, max: foo, at_most: 1}\n");
  CHECK_THAT(read.faults, Catch::Contains("'maxx'; did you mean 'max'?"));
  CHECK_THAT(read.faults, Catch::Contains("d.yaml:2:3: claims: a claim is a map"));
  CHECK_THAT(read.faults, Catch::Contains("d.yaml:3:18: claims.max: 'foo' is not recorded"));
}

TEST_CASE("what a claim reads has one unit, that of a parameter included") {
  CHECK(faults_of("{that: a, where: rig.x > 1 N, max: time, at_most: 1 s}") ==
        "d.yaml:1:26: claims.where: '>' joins m and N; they must have the same unit\n");
  CHECK(faults_of("{that: a, max: push.force - $reach, at_most: 1}") ==
        "d.yaml:1:29: claims.max: '-' joins N and m; they must have the same unit\n");
  CHECK(faults_of("{that: a, where: abs(rig.x) < $reach, max: rig.x + 5 mm, at_most: 1 m}").empty());
}

TEST_CASE("a signal that is not recorded is to be recorded, and no constant if it is called e") {
  CHECK(faults_of("{that: a, max: 2*motor, at_most: 1}") ==
        "d.yaml:1:20: claims.max: 'motor' is not recorded; add it to 'record'\n");
  CHECK(faults_of("{that: a, max: time + 2*e, at_most: 1}") ==
        "d.yaml:1:27: claims.max: 'e' is not recorded; add it to 'record'\n");
  CHECK(faults_of("{that: a, max: rig.x*pi, at_most: 1}").empty());
}

TEST_CASE("one slip in a claim is told once") {
  CHECK_THAT(faults_of("{that: a, finl: time, at_most: 1 s}"),
             Catch::StartsWith("d.yaml:1:13: claims: a claim has no 'finl'; did you mean 'final'?") &&
                 !Catch::Contains("needs one"));
  CHECK_THAT(faults_of("{that: a, at: {tim: 1 s, value: time}, at_most: 1 s}"),
             Catch::Contains("it has no 'tim'") && !Catch::Contains("is missing"));
  CHECK(faults_of("{that: a, max: time, equals: 0 s, within: 1 %}") ==
        "d.yaml:1:45: claims.within: 1 % of 0 is 0; give a tolerance with the unit of the value\n");
}

}  // namespace stepwire::claim
