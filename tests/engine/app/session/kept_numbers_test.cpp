#include <catch2/catch.hpp>
#include <cmath>

#include "blocks/register.hpp"
#include "engine/app/session/run_files.hpp"
#include "engine/app/session/session.hpp"
#include "tests/engine/app/cli/small_study.hpp"

namespace stepwire::session {
using Catch::Contains;

namespace {

const Registry& library() {
  static const Registry registry = blocks();
  return registry;
}

/// 1 - exp(-t/tau), for half a second.
std::string lag(const std::string& sweep, const std::string& more = "") {
  return "stepwire: 1\ntitle: t\nstep: 1 ms\nstop: 500 ms\nsolver: rk4\nparameters: {tau: 10 ms}\nrecord: "
         "lag\n"
         "blocks:\n  one: {block: Constant, value: 1}\n  lag: {block: Lag, tau: $tau, u: one}\nsweep: " +
         sweep + "\n" + more;
}

Outcome outcome_of(const std::string& text) {
  const Scratch folder;
  folder.file("lag.yaml", text);
  Session session(library());
  return session.run(session.load(folder.path("lag.yaml")));
}

std::string refusal(const std::string& text) {
  try {
    outcome_of(text);
  } catch (const yaml::Error& error) {
    return error.what();
  }
  return "was taken";
}

}  // namespace

TEST_CASE("a sweep keeps reductions of each run as columns of one row") {
  const Outcome outcome =
      outcome_of(lag("{tau: [10 ms, 20 ms], keep: {rise: rise_time(lag), end: final(lag), ratio: "
                     "rise_time(lag)/tau}}",
                     "claims:\n  - {that: a, max: abs(rise - log(9)*tau), at_most: 1 us}\n"
                     "  - {that: b, fraction_of_runs: rise < 30 ms, equals: 0.5}\n"));
  REQUIRE(outcome.result.recordings.size() == 1);
  const table::Table& table = outcome.result.recordings[0].table;
  REQUIRE(table.rows() == 2);
  CHECK(table.find("tau")->values == std::vector<double>{0.01, 0.02});
  CHECK(table.find("rise")->unit == "s");
  for (std::size_t run = 0; run < 2; ++run)
    CHECK(table.find("ratio")->values[run] == Approx(std::log(9.0)).epsilon(1e-3));
  for (const claim::Verdict& verdict : outcome.verdicts) CHECK(verdict.note == "");
  CHECK(outcome.verdicts.at(1).holds);
}

TEST_CASE("figures and claims name what is kept, and nothing else") {
  const std::string keep = "{tau: [10 ms, 20 ms], keep: {end: final(lag)}}";
  CHECK_THAT(refusal(lag(keep, "claims: [{that: a, max: lag, at_most: 1}]\n")),
             Contains("'lag' is none of the numbers that the sweep keeps of a run"));
  CHECK_THAT(refusal(lag("{tau: [10 ms], keep: {tau: final(lag)}}")), Contains("'tau' is a column already"));
  CHECK_THAT(refusal(lag("{tau: [10 ms], keep: {a: lag}}")), Contains("is no number of a run"));
  CHECK_THAT(refusal(lag("{tau: [10 ms], keep: last}")), Contains("'last' is not allowed"));
}

TEST_CASE("a sensitivity finds what is kept, by the design of the sweep") {
  const Outcome outcome =
      outcome_of(lag("{tau: {uniform: [10 ms, 20 ms]}, design: {samples: 64, kind: saltelli}, "
                     "keep: {rise: rise_time(lag)}}",
                     "sensitivity: {of: {r: rise}}\n"
                     "claims: [{that: a, final: r.total.tau, equals: 1, within: 0.02}]\n"));
  CHECK(outcome.verdicts.at(0).holds);
  CHECK_THAT(refusal(lag("{tau: [10 ms, 20 ms]}", "sensitivity: {of: {r: max(lag)}}\n")),
             Contains("needs a sweep that draws"));
}

TEST_CASE("samples of any other design have rank correlations") {
  const Outcome outcome =
      outcome_of(lag("{tau: {uniform: [10 ms, 20 ms]}, design: {samples: 40}, keep: {rise: rise_time(lag)}}",
                     "sensitivity: {of: {r: rise, f: 1/rise}}\n"
                     "claims:\n  - {that: a, final: r.rank.tau, equals: 1, within: 1e-9}\n"
                     "  - {that: b, final: f.partial.tau.low, equals: -1, within: 1e-9}\n"
                     "figure: {plot: sensitivity, of: r}\n"));
  for (const claim::Verdict& verdict : outcome.verdicts) CHECK(verdict.holds);
  CHECK_THAT(refusal(lag("{one.value: {words: {1: 1, 2: 1}}, design: {samples: 9}}",
                         "sensitivity: {of: {r: max(lag)}}\n")),
             Contains("words have no ranks"));
}

TEST_CASE("a kept number may name those before it, also in what it reduces") {
  const Outcome outcome = outcome_of(lag(
      "{tau: [10 ms, 20 ms], keep: {m: mean(lag), square: mean(lag^2), v: mean((lag - m)^2), d: sqrt(v)/m}}",
      "claims:\n  - {that: a, max: abs(v/(square - m^2) - 1), at_most: 1e-9}\n"
      "  - {that: b, max: abs(d*m - sqrt(v)), at_most: 1e-12}\n"));
  for (const claim::Verdict& verdict : outcome.verdicts) CHECK(verdict.holds);
  CHECK_THAT(refusal(lag("{tau: [10 ms], keep: {v: mean((lag - m)^2), m: mean(lag)}}")), Contains("'m'"));
}

TEST_CASE("kept numbers of all cases of a point stand in one row") {
  const Outcome outcome = outcome_of(
      lag("{tau: [10 ms, 20 ms], cases: {small: {}, large: {one.value: 3}}, keep: {end: final(lag)}}",
          "claims:\n  - {that: a, max: abs(large.end/small.end - 3), at_most: 1e-12}\n"
          "  - {that: b, fraction_of_runs: large.end > small.end && tau > 15 ms, equals: 0.5}\n"
          "  - {that: c, final: large.end, at_most: 2.5}\n"));
  CHECK(outcome.result.recordings.at(0).table.rows() == 4);
  const table::Table& table = outcome.recordings()[0].table;
  REQUIRE(table.rows() == 2);
  CHECK(table.find("tau")->values == std::vector<double>{0.01, 0.02});
  CHECK(table.find("small.end")->values[0] == Approx(1.0).epsilon(1e-6));
  CHECK(table.find("large.end")->values[1] == Approx(3.0).epsilon(1e-6));
  CHECK(outcome.verdicts.at(0).holds);
  CHECK(outcome.verdicts.at(1).holds);
  CHECK_THAT(outcome.verdicts.at(1).shown, Contains("in 2 runs"));
  CHECK_FALSE(outcome.verdicts.at(2).holds);
  CHECK(outcome.verdicts.at(2).worst == "tau=10 ms");
}

TEST_CASE("rows of runs say of which case they are") {
  const Outcome outcome =
      outcome_of(lag("{cases: {small: {}, large: {one.value: 3, tau: 20 ms}}}",
                     "claims:\n  - {that: a, where: case == \"large\", max: lag, equals: 3, within: 1e-6}\n"
                     "  - {that: b, where: case == \"small\", max: abs(tau - 10 ms), at_most: 0 s}\n"));
  for (const claim::Verdict& verdict : outcome.verdicts) CHECK(verdict.holds);
}

TEST_CASE("keys of a tuning that are about a study are refused without one") {
  for (const std::string key : {"experiments", "study_seed"})
    CHECK_THAT(refusal(lag("{tau: [10 ms]}",
                           "tune: {parameters: {tau: {from: 1 ms, to: 9 ms}}, minimise: max(lag), " + key +
                               ": 3}\n")),
               Contains("tune." + key + ": goes with a section 'study'"));
}

TEST_CASE("cases set what something has, once, and nothing that is swept beside them") {
  CHECK_THAT(refusal(lag("{cases: {a: {}, b: {gain: 2}}}")), Contains("sweep.cases.gain"));
  CHECK_THAT(refusal(lag("{cases: {a: {}}}")), Contains("are two or more by name"));
  CHECK_THAT(refusal(lag("{tau: [1 ms], cases: {a: {}, b: {tau: 2 ms}}}")),
             Contains("'tau' is swept beside the cases"));
  CHECK_THAT(refusal(lag("{together: true, tau: [1 ms], cases: {a: {}, b: {one.value: 2}}}")),
             Contains("leave out 'together'"));
  CHECK_THAT(
      refusal(lag("{lag.tau: [9 ms, 8 ms], cases: {lag: {}, b: {one.value: 2}}, keep: {tau: max(lag)}}")),
      Contains("'lag.tau' would be two columns"));
  CHECK_THAT(refusal(lag("{cases: {a: {}, b: {one.value: 2}}, keep: {x: max(lag)}}",
                         "tune: {parameters: {tau: [1 ms, 9 ms]}, minimise: max(lag)}\n")),
             Contains("tune: has single runs"));
}

}  // namespace stepwire::session
