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
  CHECK_THAT(refusal(lag("{tau: {uniform: [10 ms, 20 ms]}, design: {samples: 64}}",
                         "sensitivity: {of: {r: max(lag)}}\n")),
             Contains("needs a sweep whose design draws for it"));
}

}  // namespace stepwire::session
