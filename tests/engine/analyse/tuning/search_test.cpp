// How tunings search: starts, threads, runs that fail, what cannot be held.
#include <catch2/catch.hpp>
#include <cmath>

#include "engine/simulate/codegen/generated_code.hpp"
#include "engine/simulate/run/code_trial.hpp"
#include "tests/engine/analyse/tuning/tune_text.hpp"

namespace stepwire::tuning {

using Catch::Contains;

namespace {

// (a^2 - 1)^2 + 0.3 a has two minima, at the roots of 4 a^3 - 4 a + 0.3: 0.9602 and, lower, -1.0355.
const char* const two_valleys = "(u1^2 - 1)^2 + 0.3*u1";

bool same_history(const TuneResult& one, const TuneResult& other) {
  if (one.history.size() != other.history.size()) return false;
  for (std::size_t i = 0; i < one.history.size(); ++i) {
    const Evaluation &a = one.history[i], &b = other.history[i];
    if (a.values != b.values || a.objective != b.objective || a.margins != b.margins || a.start != b.start)
      return false;
  }
  return true;
}

}  // namespace

TEST_CASE("One search stays in the valley where it begins, several find the lowest one") {
  const std::string tune = "  parameters: {a: {from: -3, to: 3, start: 1.2}}\n  minimise: final(cost)\n";
  CHECK(tuned(tune_text(cost_of(two_valleys, tune)), "a") == Approx(0.9602).margin(1e-3));
  const TuneResult several = tune_text(cost_of(two_valleys, tune + "  starts: 8\n"));
  CHECK(tuned(several, "a") == Approx(-1.0355).margin(1e-3));
  CHECK(several.starts.size() == 8);
  const TuneResult global = tune_text(cost_of(two_valleys, tune + "  method: isres\n"));
  CHECK(tuned(global, "a") == Approx(-1.0355).margin(1e-3));
}

TEST_CASE("A tuning looks at the same points whatever the number of threads") {
  const std::string yaml =
      "sweep: {c: [0, 1, 5]}\n" +
      cost_of("(u1 - u3)^2 + u2^2*(1 + sin(5*u1))",
              "  parameters: {a: {from: -9, to: 9}, b: {from: 0.01, to: 10, scale: log}}\n"
              "  minimise: final(cost) + 0.1*max(b_)\n  starts: 5\n  seed: 7\n  evaluations: 60\n"
              "  subject_to: [{that: b is not small, min: b_, at_least: 0.1}]\n");
  const TuneResult one = tune_text(yaml, nullptr, {.threads = 1});
  CHECK(same_history(one, tune_text(yaml, nullptr, {.threads = 2})));
  CHECK(same_history(one, tune_text(yaml, nullptr, {.threads = 7})));
  CHECK_FALSE(same_history(one, tune_text(yaml.substr(0, yaml.find("  seed: 7")) + "  seed: 8\n" +
                                          yaml.substr(yaml.find("  evaluations")))));
}

TEST_CASE("Compiled runs give the same history as interpreted ones") {
  codegen::GeneratedCode code{run::code_trial()};
  const std::string yaml =
      "sweep: {c: [0, 2]}\n" + cost_of("(u1 - u3)^2 + u2^2",
                                       "  parameters: {a: {from: -9, to: 9}, b: {from: -1, to: 5}}\n"
                                       "  minimise: final(cost)\n");
  const TuneResult compiled = tune_text(yaml, &code);
  CHECK(compiled.compiled);
  CHECK(same_history(compiled, tune_text(yaml)));
}

TEST_CASE("Values that the diagram refuses and runs that diverge are bad points, counted and named") {
  // From a = 1 on x grows beyond all numbers; below 0 the parameter is refused.
  const TuneResult result = tune_text(R"(step: 1 s
stop: 2000 s
parameters: {a: {value: 0.5, at_least: 0, doc: x}}
blocks:
  x:    {block: UnitDelay, u: next, initial: 1}
  next: {block: Expression, u: x, expression: "(1 + 10*max(0, $a - 1))*u1"}
  cost: {block: Expression, u: x, expression: "($a - 2)^2 + 0*u1"}
record: [cost]
tune:
  parameters: {a: {from: -4, to: 4, start: 0.5}}
  minimise: final(cost)
  starts: 6
)");
  CHECK(result.feasible);
  CHECK(tuned(result, "a") == Approx(1.0).margin(0.2));
  CHECK(result.bad > 0);
  REQUIRE_FALSE(result.findings.empty());
  CHECK_THAT(result.findings.back(), Contains("evaluations gave nothing to compare, the first since"));
  std::size_t refused = 0, diverged = 0;
  for (const Evaluation& one : result.history) {
    if (one.fault.find("below 0") != std::string::npos || one.values[0] < 0.0) ++refused;
    if (one.fault.find("became inf") != std::string::npos) ++diverged;
    CHECK(one.is_bad() == (one.values[0] < 0.0 || one.values[0] > 1.1 || !one.fault.empty()));
  }
  CHECK(refused > 0);
  CHECK(diverged > 0);
}

TEST_CASE("Where no start can be run, that is an error which says why") {
  CHECK_THAT(
      tune_error(cost_of("sqrt(u1 - 10)",
                         "  parameters: {a: {from: 0, to: 1, start: 0.5}}\n  minimise: final(cost)\n")),
      Contains("no start can be evaluated; give one that runs: "));
}

TEST_CASE("Claims that never hold together are named, with the nearest that was found") {
  const TuneResult result =
      tune_text(cost_of("u1",
                        "  parameters: {a: {from: 0, to: 10, start: 3}}\n  minimise: final(cost)\n"
                        "  subject_to:\n    - {that: a is large, final: a_, at_least: 20}\n"
                        "    - {that: a is no negative number, final: a_, at_least: -1}\n"));
  CHECK_FALSE(result.feasible);
  CHECK(tuned(result, "a") == Approx(10.0).margin(1e-3));
  REQUIRE(result.claims.size() == 2);
  CHECK_FALSE(result.claims[0].verdict.holds);
  CHECK(result.claims[0].margin == Approx(-10.0).margin(1e-3));
  CHECK(result.claims[1].verdict.holds);
  REQUIRE(result.findings.size() == 1);
  CHECK(result.findings[0] == "'a is large' is in the way: nowhere nearer than 10, final a_ >= 20");
}

TEST_CASE("A start at which claims fail is left for where they hold") {
  const TuneResult result =
      tune_text(cost_of("(u1 - 3)^2 + u2^2",
                        "  parameters: {a: {from: -5, to: 5, start: -5}, b: {from: -5, to: 5, start: 5}}\n"
                        "  minimise: final(cost)\n"
                        "  subject_to: [{that: on a ring, final: \"hypot(a_, b_)\", between: [1.9, 2]}]\n"));
  CHECK(result.feasible);
  CHECK(result.objective == Approx(1.0).margin(0.01));  // a = 2, b = 0
}

TEST_CASE("The method is the one that the problem calls for") {
  const auto method = [](const std::string& minimise, const std::string& claims = "") {
    return tune_text(cost_of("u1^2", "  parameters: {a: {from: -1, to: 3}}\n  evaluations: 3\n  minimise: " +
                                         minimise + "\n" + claims))
        .method;
  };
  CHECK(method("rms(cost)") == "bobyqa");
  CHECK(method("count(cost > 1)") == "subplex");
  CHECK(method("rms(cost)", "  subject_to: [{that: x, max: a_, at_most: 2}]\n") == "cobyla");
  CHECK(method("rms(cost)", "  method: subplex\n") == "subplex");
}

TEST_CASE("A parameter that decides sizes is tuned, each of its values on a plan of its own") {
  // The delayed ramp is t - d: at 4 s it is 4 - d, which is 1 where d is 3.
  const TuneResult result = tune_text(R"(step: 10 ms
stop: 5 s
parameters: {d: {value: 1 s, at_least: 10 ms, doc: x}}
blocks:
  ramp: {block: Ramp, slope: 1}
  late: {block: Delay, u: ramp, delay: = round(d/(10 ms))*10 ms}
record: [late]
tune:
  parameters: {d: {from: 0.1 s, to: 4 s}}
  minimise: abs(at(late, 4 s) - 1)
  method: subplex
)");
  CHECK(tuned(result, "d") == Approx(3.0).margin(0.011));
}

TEST_CASE("An interruption keeps the best so far") {
  std::atomic<bool> interrupt = false;
  int calls = 0;
  const TuneOptions options{.threads = 1, .progress = [&](double, const std::string&) {
                              if (++calls == 12) interrupt = true;
                            }};
  const TuneResult result = tune_text(cost_of("(u1 - 3)^2 + (u2 - 2)^2",
                                              "  parameters: {a: {from: -9, to: 9}, b: {from: -9, to: 9}}\n"
                                              "  minimise: final(cost)\n"),
                                      nullptr, options, &interrupt);
  CHECK(result.interrupted);
  CHECK(result.history.size() == 12);
  CHECK(result.feasible);
  CHECK(result.objective <= result.start_objective);
}

}  // namespace stepwire::tuning
