#include <catch2/catch.hpp>
#include <cmath>

#include "engine/analyse/statistics/proportion.hpp"
#include "tests/engine/view/plot/samples.hpp"

namespace stepwire::claim {
using namespace testing;
using Catch::Contains;

namespace {

/// So many runs of two rows; run k goes from 0 to k.
std::vector<record::Recording> runs(int count) {
  record::Recording recording;
  recording.starts.clear();
  auto& columns = recording.table.columns;
  columns = {column("time", "s", {}), column("rig.x", "m", {}), column("current", "A", {})};
  for (int k = 1; k <= count; ++k)
    for (const double row : {0.0, 1.0}) {
      if (row == 0.0) recording.starts.push_back(columns[0].values.size());
      columns[0].values.push_back(row);
      columns[1].values.push_back(row * k);
      columns[2].values.push_back(k);
    }
  return {recording};
}

Verdict verdict_of(const std::string& text, const std::vector<record::Recording>& recordings) {
  const auto read = claims_of("- {that: a, " + text + "}");
  INFO(read.faults);
  REQUIRE(read.faults.empty());
  return judge(read.claims.at(0), recordings);
}

std::string faults_of(const std::string& text) {
  return claims_of("- {that: a, " + text + "}").faults;
}

}  // namespace

TEST_CASE("a fraction of runs counts each run once, with the interval of Clopper and Pearson") {
  const Verdict verdict = verdict_of("fraction_of_runs: max(rig.x) < 30.5 m, at_least: 0.25", runs(100));
  CHECK(verdict.value == 0.3);
  const auto interval = statistics::proportion_interval(30, 100, 0.95);
  REQUIRE(verdict.interval);
  CHECK(verdict.interval->low == interval.low);
  CHECK(verdict.interval->high == interval.high);
  CHECK(verdict.shown == "0.3 in 100 runs (0.2124 to 0.3998 with 95 %)");
  CHECK(verdict.holds);
  CHECK(verdict.check == "fraction of runs in which max(rig.x) < 30.5 m >= 0.25");
}

TEST_CASE("with a confidence the whole interval has to satisfy a claim") {
  CHECK_FALSE(
      verdict_of("fraction_of_runs: max(rig.x) < 30.5 m, at_least: 0.25, confidence: 95 %", runs(100)).holds);
  CHECK(
      verdict_of("fraction_of_runs: max(rig.x) < 30.5 m, at_least: 0.2, confidence: 95 %", runs(100)).holds);
  CHECK(verdict_of("fraction_of_runs: max(rig.x) < 30.5 m, between: [0.2, 0.45], confidence: 95 %", runs(100))
            .holds);
}

TEST_CASE("a quantile over runs lies between order statistics") {
  const Verdict verdict = verdict_of(
      "quantile_of_runs: {share: 50 %, value: final(rig.x)}, equals: 50.5 m, within: 1 um", runs(100));
  CHECK(verdict.holds);
  REQUIRE(verdict.interval);
  CHECK(verdict.interval->low == 40.0);
  CHECK(verdict.interval->high == 61.0);
  const Verdict few =
      verdict_of("quantile_of_runs: {share: 95 %, value: final(rig.x)}, at_most: 100 m", runs(10));
  CHECK(std::isinf(few.interval->high));
}

TEST_CASE("runs that where leaves out do not count, and swept parameters may be named") {
  CHECK(verdict_of("fraction_of_runs: max(rig.x) < 30.5 m, where: current > 20 A, equals: 1/8, within: 1e-12",
                   runs(100))
            .holds);
}

TEST_CASE("what is wrong with a claim about runs is one sentence") {
  CHECK_THAT(faults_of("fraction_of_runs: rig.x < 1 m, at_least: 0.5"), Contains("is no number of a run"));
  CHECK_THAT(faults_of("fraction_of_runs: max(rig.x), at_least: 0.5"), Contains("is in m and no condition"));
  CHECK_THAT(faults_of("fraction_of_runs: max(rig.x) < 1 m, at_least: 0"), Contains("cannot fail"));
  CHECK_THAT(faults_of("fraction_of_runs: max(rig.x) < 1 m, at_least: 0.5, confidence: 2"),
             Contains("2 is not allowed"));
  CHECK_THAT(faults_of("max: rig.x, at_most: 1, confidence: 95 %"), Contains("goes with"));
}

}  // namespace stepwire::claim
