#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <cmath>

#include "tests/engine/view/plot/samples.hpp"

namespace stepwire::claim {
using namespace testing;

namespace {

Verdict verdict_of(const std::string& text, const std::vector<record::Recording>& recordings) {
  const auto read = claims_of("- {that: a, " + text + "}");
  INFO(read.faults);
  REQUIRE(read.faults.empty());
  return judge(read.claims.at(0), recordings);
}

/// One run with these columns x over time.
std::vector<record::Recording> record_of(std::vector<double> time, std::vector<double> x,
                                         std::vector<std::size_t> starts = {0}) {
  record::Recording recording;
  recording.table.columns = {column("time", "s", std::move(time)), column("rig.x", "m", std::move(x))};
  recording.starts = std::move(starts);
  return {recording};
}

}  // namespace

TEST_CASE("mean and rms of a sine over half a period are 2/pi and the square root of a half") {
  std::vector<double> time, x;
  for (int i = 0; i <= 2000; ++i) {
    // Rows are closer together at the end: the mean is one over time, not over rows.
    const double part = i / 2000.0;
    time.push_back(M_PI * std::sqrt(part));
    x.push_back(std::sin(time.back()));
  }
  const auto records = record_of(time, x);
  CHECK(verdict_of("mean: rig.x, at_most: 1", records).value == Approx(2.0 / M_PI).epsilon(1e-4));
  CHECK(verdict_of("rms: rig.x, at_most: 1", records).value == Approx(std::sqrt(0.5)).epsilon(1e-4));
}

TEST_CASE("a whole number is shown with all its digits") {
  const auto shown = [](double value) {
    return verdict_of(fmt::format("final: rig.x, at_most: {} m", std::abs(2.0 * value)),
                      record_of({0, 1}, {0, value}))
        .shown;
  };
  CHECK(shown(832040.0) == "832040 m");
  CHECK(shown(-30000.0) == "-30000 m");
  CHECK(shown(999999999999999.0) == "999999999999999 m");
  CHECK(shown(1e15) == "1e+15 m");
  CHECK(shown(832040.5) == "8.32e+05 m");
}

TEST_CASE("rms and fit are right where squares of the rows are too large or too small for a double") {
  for (const double size : {1e-200, 1e200, 1e-300, 1e300}) {
    INFO(size);
    const auto records = record_of({0, 1, 2, 3}, {3 * size, -3 * size, 3 * size, 3 * size});
    CHECK(verdict_of("rms: rig.x, at_most: 1e301 m", records).value == Approx(3 * size));
    CHECK(verdict_of("fit: [rig.x, 2*rig.x], at_most: 99", record_of({0, 1}, {size, 3 * size})).value ==
          Approx(100.0 * (1.0 - std::sqrt(1.25))));  // errors of 1 and 3 beside -2 and 2
  }
}

TEST_CASE("rows that are left out and ends of runs break an interval of time") {
  // Runs 0..2 and 0..1; the row at 1 s of the first is left out, so that only the second run has a duration.
  const auto records = record_of({0, 1, 2, 0, 1}, {8, 9, 8, 2, 4}, {0, 3});
  CHECK(verdict_of("mean: rig.x, where: rig.x < 9 m, at_most: 1", records).value == 3.0);
  CHECK(verdict_of("mean: rig.x, at_most: 1", records).value == Approx((17.0 + 3.0) / 3.0));
}

TEST_CASE("the worst run is shown for a final value") {
  const auto records = record_of({0, 1, 0, 1, 0, 1}, {0, 5, 0, 7, 0, 6}, {0, 2, 4});
  const Verdict verdict = verdict_of("final: rig.x, at_most: 6.5 m", records);
  CHECK(verdict.value == 7.0);
  CHECK(verdict.shown == "7 m, the worst of 3 runs");
  CHECK_FALSE(verdict.holds);
  CHECK(verdict_of("final: rig.x, at_least: 5 m", records).holds);
  CHECK(verdict_of("at: {time: 1 s, value: rig.x}, equals: 6, within: 1", records).value == 5.0);
}

TEST_CASE("max, min, spread, fraction and count are what they say") {
  const auto records = record_of({0, 1, 2, 3, 0, 1}, {0, 2, -1, 3, 4, 0}, {0, 4});
  CHECK(verdict_of("max: rig.x, at_most: 4", records).value == 4.0);
  CHECK(verdict_of("min: rig.x, at_most: 4", records).value == -1.0);
  CHECK(verdict_of("spread: rig.x, at_most: 4", records).value == 5.0);
  CHECK(verdict_of("fraction: rig.x > 1, at_most: 50 %", records).shown == "50 %");
  // A run that begins above has no edge there.
  CHECK(verdict_of("count: rig.x > 1, equals: 2", records).holds);
}

TEST_CASE("a quantile is that of all selected rows, after Hazen") {
  // The k-th of ten values is the quantile (k - 1/2)/10: a quarter is the third, and 0.3 is between two.
  const auto records = record_of({0, 0, 0, 0, 0, 0, 0, 0, 0, 0}, {5, 3, 1, 9, 7, 10, 8, 6, 4, 2},
                                 {0, 1, 2, 3, 4, 5, 6, 7, 8, 9});
  CHECK(verdict_of("quantile: {share: 25 %, value: rig.x}, at_most: 4 m", records).value == 3.0);
  CHECK(verdict_of("quantile: {share: 0.3, value: rig.x}, at_most: 4 m", records).value == Approx(3.5));
  CHECK(verdict_of("quantile: {share: 0.5, value: rig.x}, at_most: 6 m", records).shown == "5.5 m");
  CHECK(verdict_of("quantile: {share: 0, value: rig.x}, where: rig.x > 4, at_most: 9 m", records).value ==
        5.0);
  CHECK_THAT(claims_of("- {that: a, quantile: {share: 120 %, value: rig.x}, at_most: 1 m}").faults,
             Catch::Contains("share"));
}

TEST_CASE("of runs with one row each it is told of how many a condition holds") {
  const auto records = record_of({0, 0, 0, 0, 0}, {1, 2, 3, 4, 5}, {0, 1, 2, 3, 4});
  CHECK(verdict_of("fraction: rig.x > 1 m, at_least: 0.75", records).shown == "0.8, 4 of 5");
  CHECK(verdict_of("fraction: rig.x > 1 m, where: rig.x < 4, at_least: 0.5", records).shown ==
        "0.6667, 2 of 3");
  CHECK(verdict_of("fraction: rig.x > 1, at_least: 0.5", record_of({0, 1}, {1, 2})).shown == "0.5");
}

TEST_CASE("the fit of a constant error is that of its definition") {
  const auto records = record_of({0, 1, 2, 3}, {1, 2, 3, 4});
  // |e| = 0.1 * 2, |y - mean| = sqrt(5).
  const Verdict verdict = verdict_of("fit: [rig.x + 0.1, rig.x], at_least: 88 %", records);
  CHECK(verdict.value == Approx(100.0 * (1.0 - 0.2 / std::sqrt(5.0))));
  CHECK(verdict.shown == "91.06 %");
  CHECK(verdict_of("rising: {value: rig.x, over: -time}, equals: -1", records).holds);
}

TEST_CASE("a free offset takes the mean difference out of a fit") {
  const auto records = record_of({0, 1, 2, 3}, {1, 2, 3, 4});
  CHECK(verdict_of("fit: [rig.x + 0.1, rig.x], offset: free, equals: 100, within: 1e-9", records).holds);
  // 2 x - x has the mean 2.5 and the same spread about it as x, so the error is all of the variation.
  CHECK(verdict_of("fit: [2*rig.x, rig.x], offset: free, at_least: -1", records).value ==
        Approx(0.0).margin(1e-12));
}

TEST_CASE("a claim about each run shows the worst of them") {
  const auto records = record_of({0, 1, 0, 1, 0, 1}, {0, 5, 0, 7, 0, 6}, {0, 2, 4});
  const Verdict verdict = verdict_of("spread: rig.x, each_run: true, at_most: 6.5 m", records);
  CHECK(verdict.value == 7.0);
  CHECK(verdict.shown == "7 m, the worst of 3 runs");
  CHECK(verdict_of("mean: rig.x, each_run: true, at_least: 2 m", records).value == 2.5);
  // The first run never goes beyond 5 m.
  CHECK(verdict_of("min: rig.x, each_run: true, where: rig.x > 5 m, at_most: 9", records).value == 7.0);
  CHECK(verdict_of("final: rig.x, where: rig.x > 6.5 m, at_least: 9", records).value == 7.0);
}

TEST_CASE("where all runs give the same value none is the worst") {
  const auto records = record_of({0, 1, 0, 1}, {0, 5, 1, 5}, {0, 2});
  const Verdict verdict = verdict_of("final: rig.x, at_most: 6 m", records);
  CHECK(verdict.shown == "5 m");
  CHECK_FALSE(verdict.run);
}

TEST_CASE("the largest value of several runs names the run that has it, where it is the one that decides") {
  const auto records = record_of({0, 1, 0, 1, 0, 1}, {0, 5, 0, 7, -2, 6}, {0, 2, 4});
  const Verdict verdict = verdict_of("max: rig.x, at_most: 6.5 m", records);
  CHECK(verdict.shown == "7 m, the worst of 3 runs");
  CHECK(verdict.run == 1u);
  CHECK(verdict_of("min: rig.x, at_least: 0", records).run == 2u);
  CHECK(verdict_of("max: rig.x, at_least: 6 m", records).shown == "7 m");
  CHECK(verdict_of("max: rig.x, at_most: 9 m", record_of({0, 1}, {1, 2})).shown == "2 m");
  CHECK_FALSE(verdict_of("mean: rig.x, at_most: 9 m", records).run);
}

TEST_CASE("comparisons hold at their ends") {
  const auto records = record_of({0, 1}, {2, 2});
  CHECK(verdict_of("max: rig.x, at_most: 2 m", records).holds);
  CHECK(verdict_of("max: rig.x, at_least: 2 m", records).holds);
  CHECK(verdict_of("max: rig.x, between: [1, 2]", records).holds);
  CHECK(verdict_of("max: rig.x, equals: 2", records).holds);
  CHECK(verdict_of("max: rig.x, equals: 2.5, within: 20 %", records).holds);
  CHECK_FALSE(verdict_of("max: rig.x, equals: 2.5, within: 19 %", records).holds);
  CHECK_FALSE(verdict_of("max: rig.x, equals: 2.5, within: 0.4", records).holds);
}

TEST_CASE("a value just beyond its limit is not rounded onto it") {
  const Verdict verdict = verdict_of("max: rig.x, at_most: 2 mm", record_of({0}, {2.0000001e-3}));
  CHECK_FALSE(verdict.holds);
  CHECK(verdict.shown == "2.0000001 mm");
}

TEST_CASE("a value that equals the wanted one closely is shown with four digits") {
  const auto records = record_of({0}, {0.195727157});
  CHECK(verdict_of("max: rig.x, equals: 195.727157 mm, within: 1e-9 m", records).shown == "195.7 mm");
}

TEST_CASE("a claim without rows fails and says why") {
  const auto records = record_of({0, 1}, {2, 3});
  const Verdict none = verdict_of("max: rig.x, where: rig.x > 5 m, at_most: 100", records);
  CHECK_FALSE(none.holds);
  CHECK(std::isnan(none.value));
  CHECK(none.note == "'rig.x > 5 m' selects no row");
  CHECK(verdict_of("max: rig.x, at_most: 9", record_of({}, {})).note == "no row was recorded");
  CHECK(verdict_of("max: rig.x, at_most: 9", {}).note == "nothing was recorded");
  CHECK(verdict_of("max: rig.v, at_most: 9", records).note == "'rig.v' was not recorded");
  CHECK(verdict_of("at: {time: 3 s, value: rig.x}, at_most: 9", records).note ==
        "there is no row at 3 s; the record goes from 0 s to 1 s");
}

TEST_CASE("what is not a number never holds") {
  const auto records = record_of({0, 1}, {NAN, 3});
  for (const std::string reduction : {"max", "min", "mean", "rms", "spread", "count"}) {
    INFO(reduction);
    const Verdict verdict = verdict_of(reduction + ": rig.x/1 m, equals: 1", records);
    CHECK_FALSE(verdict.holds);
    CHECK_THAT(verdict.note, Catch::StartsWith("the value is not a number"));
  }
}

TEST_CASE("a comparison with an undefined number is neither true nor false") {
  const auto none = record_of({0, 0, 0}, {NAN, NAN, NAN}, {0, 1, 2});
  for (const std::string text : {"fraction: rig.x > 1 m, at_most: 0.5", "fraction: rig.x < 1 m, equals: 0",
                                 "count: rig.x > 1 m, equals: 0"}) {
    INFO(text);
    const Verdict verdict = verdict_of(text, none);
    CHECK_FALSE(verdict.holds);
    CHECK_THAT(verdict.note, Catch::Contains("undefined in 3 of 3"));
  }
  const auto one = record_of({0, 0, 0}, {NAN, 2, 3}, {0, 1, 2});
  CHECK_THAT(verdict_of("fraction: rig.x > 1 m, at_least: 0.1", one).note,
             Catch::Contains("undefined in 1 of 3"));
  CHECK(verdict_of("fraction: rig.x > 1 m, where: time >= 0 s && rig.x > 0 m, equals: 1", one).holds);
}

TEST_CASE("no claim holds by a root of a negative number in a comparison, a choice or a truth") {
  const auto negative = record_of({0, 1, 2}, {-1, -2, -3});
  for (const std::string text :
       {"fraction: sqrt(rig.x/1 m) > -1, at_most: 0.1", "count: log(rig.x/1 m) > -1, equals: 0",
        "final: 'sqrt(rig.x/1 m) < 1 ? 1 : 0', equals: 0", "final: sqrt(rig.x/1 m) != 3, equals: 1",
        "max: 'min(sqrt(rig.x/1 m), 1)', at_most: 2", "fraction: '!(sqrt(rig.x/1 m) > 1)', equals: 1",
        "fraction: rig.x < 0 m && sqrt(rig.x/1 m) < 2, equals: 0"}) {
    INFO(text);
    CHECK_FALSE(verdict_of(text, negative).holds);
  }
  CHECK(verdict_of("fraction: rig.x > 0 m && sqrt(rig.x/1 m) < 2, equals: 0", negative).holds);
  CHECK(verdict_of("fraction: rig.x < 0 m || sqrt(rig.x/1 m) < 2, equals: 1", negative).holds);
}

TEST_CASE("a value at a time is that of the last row there; between two rows a run has none") {
  const auto records = record_of({0.0, 0.3, 0.6, 0.6, 0.9}, {0, 3, 6, 60, 9});
  CHECK(verdict_of("at: {time: 0.3 s, value: rig.x}, equals: 3 m", records).value == 3.0);
  CHECK(verdict_of("at: {time: 3*0.3 s, value: rig.x}, equals: 9 m", records).value == 9.0);
  CHECK(verdict_of("at: {time: 0.6 s, value: rig.x}, equals: 60 m", records).value == 60.0);
  const Verdict between = verdict_of("at: {time: 0.5 s, value: rig.x}, equals: 6 m", records);
  CHECK_FALSE(between.holds);
  CHECK(between.note == "there is no row at 0.5 s; the nearest ones are at 0.3 s and 0.6 s");
}

TEST_CASE("a claim that is known not to hold surprises when it holds") {
  const auto records = record_of({0, 1}, {2, 3});
  const Verdict known = verdict_of("max: rig.x, at_most: 1, disagrees: too strong", records);
  CHECK(known.word() == "does not hold (known)");
  CHECK(known.disagrees == "too strong");
  CHECK_FALSE(known.fails());
  CHECK_FALSE(known.surprises());
  const Verdict surprise = verdict_of("max: rig.x, at_most: 9, disagrees: too strong", records);
  CHECK(surprise.surprises());
  CHECK(verdict_of("max: rig.x, at_most: 1", records).fails());
}

TEST_CASE("a small value is shown by its size beside a small bound, and as 0 beside a large one") {
  const auto records = record_of({0, 1, 2}, {0.2, 0.2, -0.2});
  CHECK(verdict_of("max: 1e-14*rig.x, at_most: 4e-15 m", records).shown == "2e-15 m");
  CHECK(verdict_of("max: rig.x + 1e-17 - rig.x, at_most: 1 m", record_of({0}, {0.2})).shown == "0 m");
  CHECK(verdict_of("final: rig.x*5e-320, at_least: -1 mm", records).shown == "0 mm");
  CHECK(verdict_of("max: 1e-15*rig.x, at_most: 0 m", records).shown == "2e-16 m");
  CHECK(verdict_of("max: 1e-9*rig.x, at_most: 1 m", records).shown == "2e-10 m");
  CHECK(verdict_of("max: rig.x - rig.x, at_most: 1 m", records).shown == "0 m");
}

TEST_CASE("a number of four digits is on that side of the bound on which the value is") {
  const auto records = record_of({0, 1}, {3.14156, 3.14156});
  CHECK(verdict_of("max: rig.x, at_most: 3.1416 m", records).shown == "3.141 m");
  CHECK(verdict_of("max: rig.x, at_most: 3.14155 m", records).shown == "3.142 m");
  CHECK(verdict_of("min: rig.x, at_least: 3.1415 m", records).shown == "3.142 m");
  CHECK(verdict_of("max: rig.x, at_least: 3.14158 m", records).shown == "3.14156 m");
}

TEST_CASE("a small length has a small unit where the file gives none") {
  const auto records = record_of({0, 1}, {0.0143, 0.0143});
  CHECK(verdict_of("max: rig.x, at_most: $reach", records).shown == "14.3 mm");
  CHECK(verdict_of("max: rig.x, at_most: 1 m", records).shown == "0.0143 m");
  CHECK(verdict_of("max: 100*rig.x, at_most: 2*$reach", records).shown == "1.43 m");
}

TEST_CASE("a value has the unit of the statement where the bound names none") {
  const auto records = record_of({0, 1}, {0.0143, 0.0143});
  const auto shown = [&](const std::string& that, const std::string& bound) {
    return judge(claims_of("- {that: \"" + that + "\", max: rig.x, at_most: " + bound + "}").claims.at(0),
                 records)
        .shown;
  };
  CHECK(shown("in 3 s it goes at most 10 cm, 2 times", "$reach") == "1.43 cm");
  CHECK(shown("in 3 s it goes at most 10 cm", "100 mm") == "14.3 mm");
  CHECK(shown("it stays within 2 of them", "$reach") == "14.3 mm");
}

TEST_CASE("a length is no condition whose share could be taken") {
  CHECK_THAT(claims_of("- {that: a, fraction: rig.x, at_most: 1}").faults,
             Catch::Contains("'rig.x' is in m and no condition; write what has to hold"));
}

}  // namespace stepwire::claim
