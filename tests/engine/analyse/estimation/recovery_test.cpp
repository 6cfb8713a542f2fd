// Fits of records that the diagram makes itself, so that the truth is known.
#include <catch2/catch.hpp>
#include <cmath>

#include "engine/simulate/codegen/generated_code.hpp"
#include "engine/simulate/run/code_trial.hpp"
#include "tests/engine/analyse/estimation/fit_text.hpp"

namespace stepwire::estimation {
using Catch::Contains;

namespace {

/// A lag with a gain follows a sine, beside a true one (tau 0.2 s, gain 3).
std::string lag(const std::string& fit, const std::string& more = "") {
  return R"(step: 10 ms
stop: 4 s
solver: rk4
parameters:
  tau: {value: 1 s, doc: x}
  gain: {value: 1, doc: x}
blocks:
  sine: {block: Sine, amplitude: 2, frequency: 1 Hz}
  truth: {block: Lag, u: sine, tau: 0.2 s, gain: 3}
  model: {block: Lag, u: sine, tau: $tau, gain: $gain}
record: [model, truth]
)" + more +
         "fit:\n" + fit;
}

const std::string both =
    "  parameters: {tau: {start: 1 s, bounds: [0.01 s, 10 s]}, gain: {start: 1, bounds: [0.1, 10]}}\n"
    "  compare: [{model: model, measured: truth}]\n";

}  // namespace

TEST_CASE("without noise the truth is found again") {
  const FitResult result = fit_text(lag(both));
  CHECK(found(result, "tau").value == Approx(0.2).epsilon(1e-7));
  CHECK(found(result, "gain").value == Approx(3.0).epsilon(1e-7));
  CHECK(result.records.at(0).comparisons.at(0).agreement > 99.999);
}

TEST_CASE("a wide bound that a long first step reaches does not hold a time constant") {
  // At 10 ms, half of the step, Runge-Kutta's cost has a minimum at the bound itself. The truth is 0.37 s.
  const auto fit = [](const std::string& start) {
    return fit_text(
        "step: 20 ms\nstop: 4 s\nsolver: rk4\nparameters: {k: 1, tau: 1 s}\nrecord: [model, truth]\nblocks:\n"
        "  u: {block: Step, time: 0.6 s, after: $k}\n  v: {block: Step, time: 0.6 s, after: 2.4}\n"
        "  model: {block: Lag, u: u, tau: $tau}\n  truth: {block: Lag, u: v, tau: 0.37 s}\n"
        "fit:\n  parameters: {k: {start: 1, bounds: [0.1, 10]}, tau: {start: " +
        start + ", bounds: [10 ms, 10 s]}}\n  compare: [{model: model, measured: truth}]\n");
  };
  for (const char* start : {"10 ms", "12 ms", "50 ms", "0.2 s", "0.5 s", "1 s", "3 s", "9 s", "10 s"}) {
    INFO(start);
    const FitResult result = fit(start);
    CHECK(result.converged);
    CHECK(found(result, "tau").value == Approx(0.37).epsilon(1e-6));
    CHECK(found(result, "k").value == Approx(2.4).epsilon(1e-6));
  }
}

TEST_CASE(
    "what no parameter moves is run once and played back where it is read at ticks alone, to the same "
    "result") {
  codegen::GeneratedCode code{run::code_trial()};
  std::string sampled = lag(both), stepped = lag(both);
  sampled.replace(sampled.find("frequency: 1 Hz}"), 16, "frequency: 1 Hz, every: 20 ms}");
  stepped.replace(stepped.find("rk4"), 3, "euler");
  for (plan::CodeSource* source :
       {static_cast<plan::CodeSource*>(nullptr), static_cast<plan::CodeSource*>(&code)}) {
    const FitResult whole = fit_text(lag(both), source), part = fit_text(sampled, source),
                    euler = fit_text(stepped, source);
    CHECK_FALSE(whole.in_part);  // the solver reads the sine between ticks
    CHECK(part.in_part);
    CHECK(euler.in_part);
    for (const FitResult* result : {&whole, &part, &euler}) {
      CHECK(found(*result, "tau").value == Approx(0.2).epsilon(1e-7));
      CHECK(found(*result, "gain").value == Approx(3.0).epsilon(1e-7));
    }
  }
}

TEST_CASE("records may differ in the value of a block that is run once and played back") {
  codegen::GeneratedCode code{run::code_trial()};
  std::string text = lag(both, "sweep: {sine.amplitude: [1, 2, 3]}\n");
  text.replace(text.find("rk4"), 3, "euler");
  for (plan::CodeSource* source :
       {static_cast<plan::CodeSource*>(nullptr), static_cast<plan::CodeSource*>(&code)}) {
    const FitResult result = fit_text(text, source);
    CHECK(result.in_part);
    CHECK(result.records.size() == 3);
    CHECK(found(result, "tau").value == Approx(0.2).epsilon(1e-7));
    CHECK(found(result, "gain").value == Approx(3.0).epsilon(1e-7));
  }
}

TEST_CASE("several starts find the truth, and the same seed goes the same way") {
  const FitResult once = fit_text(lag(both + "  starts: 5\n  seed: 7\n"));
  const FitResult again = fit_text(lag(both + "  starts: 5\n  seed: 7\n"));
  CHECK(once.starts.size() == 5);
  CHECK(found(once, "tau").value == Approx(0.2).epsilon(1e-7));
  CHECK(found(once, "tau").value == found(again, "tau").value);
}

TEST_CASE("differential evolution may go ahead") {
  const FitResult result = fit_text(lag(both + "  global: {population: 12, generations: 8}\n"));
  CHECK(result.starts.size() == 2);
  CHECK(found(result, "gain").value == Approx(3.0).epsilon(1e-7));
}

TEST_CASE(
    "a parameter that no straight line describes is planned for each run, of the one compilation, to the "
    "same result") {
  codegen::GeneratedCode code{run::code_trial()};
  std::string text = lag(both);
  text.replace(text.find("tau: $tau"), 9, "tau: = tau^2 / 1 s");
  const FitResult result = fit_text(text, &code);
  CHECK(result.compiled);
  CHECK(found(result, "tau").value == Approx(std::sqrt(0.2)).epsilon(1e-7));
}

TEST_CASE("only the product of two gains in a row can be known, and it is said") {
  std::string text =
      lag("  parameters: {before: {start: 2}, gain: {start: 1}}\n"
          "  compare: [{model: behind, measured: truth}]\n");
  text.replace(text.find("  tau: {value: 1 s"), 18, "  before: {value: 1");
  text.replace(text.find("  model: {block: Lag, u: sine, tau: $tau"), 40,
               "  model: {block: Lag, u: sine, tau: 0.2 s");
  text.replace(text.find("record: [model"), 14,
               "  behind: {block: Gain, u: model, gain: $before}\nrecord: [behind");
  const FitResult result = fit_text(text);
  CHECK(found(result, "before").value * found(result, "gain").value == Approx(3.0).epsilon(1e-6));
  REQUIRE(result.findings.size() == 1);
  CHECK_THAT(result.findings[0],
             Contains("only the product of before and gain can be known; fix one of them"));
  CHECK(std::isnan(found(result, "gain").standard_error));
}

TEST_CASE("what each record has for itself is found for each, beside what they share") {
  const FitResult result = fit_text(
      R"(step: 10 ms
stop: 2 s
solver: rk4
parameters:
  tau: {value: 1 s, doc: x}
  bias: {value: 0, doc: x}
  true_bias: {value: 0, doc: x}
sweep: {true_bias: [1, -2, 0.5]}
blocks:
  sine: {block: Sine, amplitude: 2, frequency: 1 Hz}
  true_lag: {block: Lag, u: sine, tau: 0.2 s}
  lag: {block: Lag, u: sine, tau: $tau}
  level: {block: Constant, value: $bias}
  true_level: {block: Constant, value: $true_bias}
  truth: {block: Sum, u: [true_lag, true_level]}
  model: {block: Sum, u: [lag, level]}
record: [model, truth]
fit:
  parameters: {tau: {start: 1 s, bounds: [0.01 s, 10 s]}, bias: {start: 0, each_record: true}}
  compare: [{model: model, measured: truth}]
  hold_out: true_bias == 0.5
)");
  CHECK(result.numbers.size() == 3);
  CHECK(found(result, "tau").value == Approx(0.2).epsilon(1e-7));
  CHECK(found(result, "bias of 1").value == Approx(1.0).epsilon(1e-7));
  CHECK(found(result, "bias of -2").value == Approx(-2.0).epsilon(1e-7));
  REQUIRE(result.records.size() == 3);
  CHECK_FALSE(result.records[0].held_out);
  CHECK(result.records[0].comparisons.at(0).agreement > 99.99);
  CHECK(result.records[2].held_out);
  CHECK(result.records[2].comparisons.at(0).agreement < 99.0);  // its bias is at the start
}

TEST_CASE("the interval of a noisy fit holds the truth") {
  std::string text = lag(both);
  text.replace(text.find("record:"), 7,
               "  noise: {block: Noise, seed: 3, deviation: 0.2}\n"
               "  seen: {block: Sum, u: [truth, noise]}\nrecord:");
  text.replace(text.find("record: [model, truth"), 21, "record: [model, truth, seen");
  text.replace(text.find("measured: truth"), 15, "measured: seen");
  const FitResult result = fit_text(text);
  CHECK(result.deviation == Approx(0.2).epsilon(0.1));
  CHECK(found(result, "tau").low < 0.2);
  CHECK(found(result, "tau").high > 0.2);
  CHECK(found(result, "gain").standard_error < 0.02);
}

TEST_CASE("what the records want but no damper is, is held off and told") {
  const std::string text = R"(step: 1 ms
stop: 2 s
solver: rk4
parameters:
  gamma: {value: 0 1/m, doc: of the model}
blocks:
  v: {block: Sine, amplitude: 50 mm/s, frequency: 1 Hz}
  z: {block: BoucWen, A: 1, beta: 100, gamma: -150, velocity: v}
  truth: {block: Gain, u: z, gain: 1000}
  model: {block: MRDamper, velocity: v, current: 0 A, A: 1, beta: 100 1/m, gamma: $gamma, alpha: [1000], c: [0],
          current_range: [0 A, 1 A]}
units: {truth: N}
record: [model.force, truth]
fit:
  parameters: {gamma: {start: 0 1/m, bounds: [-300 1/m, 300 1/m]}}
  compare: [{model: model.force, measured: truth}]
)";
  codegen::GeneratedCode code{run::code_trial()};
  for (plan::CodeSource* source :
       {static_cast<plan::CodeSource*>(nullptr), static_cast<plan::CodeSource*>(&code)}) {
    const FitResult result = fit_text(text, source);
    CHECK(result.limited);
    CHECK(found(result, "gamma").value >= -100.0);
    CHECK(found(result, "gamma").value < -90.0);
    REQUIRE_FALSE(result.findings.empty());
    CHECK_THAT(result.findings.front(), Contains("|gamma| = ") && Contains("above beta = 100"));
  }
}

}  // namespace stepwire::estimation
