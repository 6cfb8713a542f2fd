#include <catch2/catch.hpp>

#include "tests/engine/view/plot/samples.hpp"

namespace stepwire::claim {
using namespace testing;
using Catch::Contains;

namespace {

std::string faults_of(const std::string& text) {
  return claims_of("- {that: a, " + text + "}").faults;
}

}  // namespace

TEST_CASE("a claim that no value can fail is refused at its comparison, with what could fail") {
  CHECK(faults_of("fraction: rig.x > 0, at_least: 0") ==
        "d.yaml:1:44: claims.at_least: 'fraction' lies between 0 and 1, so that this cannot fail; give a "
        "number above 0\n");
  CHECK_THAT(faults_of("fraction: rig.x > 0, at_most: 100 %"), Contains("give a number below 1"));
  CHECK_THAT(faults_of("fraction: rig.x > 0, between: [0, 1]"), Contains("leave out a part of that range"));
  CHECK_THAT(faults_of("fraction: rig.x > 0, equals: 0.5, within: 0.5"), Contains("cannot fail"));
  CHECK_THAT(faults_of("count: rig.x > 0, at_least: 0"), Contains("'count' is 0 or more"));
  CHECK_THAT(faults_of("rms: rig.x, at_least: -1 mm"), Contains("'rms' is 0 or more"));
  CHECK_THAT(faults_of("spread: rig.x, at_least: 0 mm"), Contains("'spread' is 0 or more"));
  CHECK_THAT(faults_of("rising: {value: rig.x, over: time}, between: [-1, 1]"), Contains("cannot fail"));
  CHECK_THAT(faults_of("rising: {value: rig.x, over: time}, at_most: 1"), Contains("cannot fail"));
  CHECK_THAT(faults_of("fit: [rig.x, rig.x], at_most: 100 %"), Contains("'fit' is 100 or less"));
}

TEST_CASE("a claim that some value can fail is taken, however wide it is") {
  for (const std::string text :
       {"fraction: rig.x > 0, at_least: 0.1 %", "fraction: rig.x > 0, between: [0, 0.99]",
        "fraction: rig.x > 0, equals: 1", "count: rig.x > 0, at_least: 1", "count: rig.x > 0, equals: 0",
        "rms: rig.x, at_most: 1 m", "spread: rig.x, between: [0 m, 1 m]", "mean: rig.x, at_least: 0 m",
        "max: rig.x, at_least: -1e300", "rising: {value: rig.x, over: time}, between: [-1, 0.9]",
        "fit: [rig.x, rig.x], at_most: 99 %"}) {
    INFO(text);
    CHECK(faults_of(text).empty());
  }
}

TEST_CASE("a claim in which nothing comes from the run is refused") {
  CHECK(faults_of("final: 3, equals: 3") ==
        "d.yaml:1:20: claims.final: '3' names nothing that the run gives, so that nothing is judged of it; "
        "name a recorded signal\n");
  CHECK_THAT(faults_of("at: {time: 1 s, value: 3}, equals: 3"), Contains("claims.at: '3' names nothing"));
  CHECK(faults_of("final: 3, where: rig.x > 0, equals: 3").empty());
  CHECK(faults_of("final: time, at_least: 1 s").empty());
  CHECK(faults_of("final: 2*$limit, at_most: 3").empty());  // a parameter may come from a fit or a sweep
}

}  // namespace stepwire::claim
