#include <catch2/catch.hpp>
#include <cmath>

#include "engine/analyse/claim/judge.hpp"
#include "engine/analyse/statistics/proportion.hpp"
#include "tests/engine/view/plot/samples.hpp"

namespace stepwire::claim {
using namespace testing;
using Catch::Contains;

namespace {

/// Makes `count` runs of two rows; run k goes from 0 to k.
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
  CHECK(verdict.shown == "0.3 in 100 runs (0.2124 to 0.3998 at 95 % confidence)");
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

TEST_CASE(
    "a claim on a quantile that so few runs do not bound is undecided, and says how many runs decide it") {
  const Verdict few =
      verdict_of("quantile_of_runs: {share: 99.9 %, value: final(rig.x)}, at_most: 100 m", runs(3));
  CHECK_FALSE(few.holds);
  CHECK(few.note ==
        "undecided: 3 runs do not bound the 99.9 % quantile from above at 95 % confidence; 3688 runs do");
  REQUIRE(few.interval);
  CHECK(few.value == 3.0);
  const auto holds = [](const std::string& claim, int count) {
    return verdict_of("quantile_of_runs: {share: 95 %, value: final(rig.x)}, " + claim, runs(count)).holds;
  };
  CHECK_FALSE(holds("at_most: 100 m", 71));  // 1 - 0.95^72 is the first above 97.5 %
  CHECK(holds("at_most: 100 m", 72));
  CHECK(holds("at_least: 1 m", 10));  // an open end does not count where the claim does not look
  CHECK_FALSE(holds("at_least: 10.5 m", 10));
  CHECK(verdict_of("quantile_of_runs: {share: 50 %, value: final(rig.x)}, equals: 2 m, within: 1 m", runs(3))
            .note == "undecided: 3 runs do not bound the 50 % quantile at 95 % confidence; 6 runs do");
  CHECK(verdict_of("quantile_of_runs: {share: 5 %, value: final(rig.x)}, at_least: 0 m, confidence: 99 %",
                   runs(3))
            .note ==
        "undecided: 3 runs do not bound the 5 % quantile from below at 99 % confidence; 104 runs do");
  CHECK(verdict_of("quantile_of_runs: {share: 100 %, value: final(rig.x)}, at_most: 100 m", runs(3)).note ==
        "undecided: no number of runs bounds the 100 % quantile from above; take a share between 0 and 1");
}

TEST_CASE("the fewest values that bound a quantile on both sides are those that probability says") {
  for (const double share : {0.001, 0.05, 0.5, 0.9, 0.999, 0.99999}) {
    const std::size_t count = statistics::values_for_both_ranks(share, 0.95);
    const double rarer = std::max(share, 1.0 - share);
    CHECK(std::pow(rarer, static_cast<double>(count)) <= 0.025);
    CHECK(std::pow(rarer, static_cast<double>(count) - 1.0) > 0.025);
  }
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

TEST_CASE("runs that come one by one are judged as all of them together") {
  const auto all = runs(7);
  for (const std::string text :
       {"final: rig.x, at_most: 6.5 m", "max: rig.x, at_most: 5 m", "min: rig.x, at_least: 0 m",
        "mean: rig.x, at_most: 2 m", "rms: rig.x, where: current > 2 A, at_most: 2 m",
        "spread: rig.x, equals: 7 m", "fraction: rig.x > 2.5 m, at_least: 0.3",
        "count: rig.x > 2.5 m, equals: 5", "quantile: {share: 25 %, value: rig.x}, at_most: 1 m",
        "at: {time: 1 s, value: rig.x}, at_most: 1 m", "max: rig.x, where: current > 9 A, at_most: 1 m",
        "fraction_of_runs: max(rig.x) < 3.5 m, equals: 3/7",
        "quantile_of_runs: {share: 50 %, value: max(rig.x)}, at_most: 9 m"}) {
    const auto read = claims_of("- {that: a, " + text + "}");
    INFO(text << read.faults);
    REQUIRE(read.faults.empty());
    Judge judge(read.claims.at(0));
    for (std::size_t run = 0; run < 7; ++run) {
      record::Recording one = all.front();
      one.starts = {0};
      for (table::Column& column : one.table.columns)
        column.values = {column.values[2 * run], column.values[2 * run + 1]};
      judge.add(std::vector{one});
    }
    const Verdict alone = judge.verdict(), together = claim::judge(read.claims.at(0), all);
    CHECK(alone.shown == together.shown);
    CHECK(alone.note == together.note);
    CHECK(alone.holds == together.holds);
    CHECK(alone.run == together.run);
    CHECK((alone.value == together.value || std::isnan(alone.value)));
  }
}

TEST_CASE("only claims that have to sort all rows, or to pair them, keep them") {
  const auto keeps = [](const std::string& text) {
    const auto read = claims_of("- {that: a, " + text + "}");
    REQUIRE(read.faults.empty());
    return keeps_rows(read.claims.at(0));
  };
  CHECK(keeps("quantile: {share: 25 %, value: rig.x}, at_most: 1 m"));
  CHECK_FALSE(keeps("mean: rig.x, at_most: 2 m"));
  CHECK_FALSE(keeps("quantile_of_runs: {share: 50 %, value: max(rig.x)}, at_most: 9 m"));
}

}  // namespace stepwire::claim
