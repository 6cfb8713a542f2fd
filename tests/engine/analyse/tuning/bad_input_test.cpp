// Faults of a section `tune`, and their messages.
#include <catch2/catch.hpp>

#include "tests/engine/analyse/tuning/tune_text.hpp"

namespace stepwire::tuning {

using Catch::Contains;

namespace {

std::string error_with(const std::string& rest, const std::string& parameters = "{a: {from: -1, to: 3}}") {
  return tune_error(cost_of("u1^2", "  parameters: " + parameters + "\n" + rest));
}

std::string of_objective(const std::string& minimise) {
  return error_with("  minimise: \"" + minimise + "\"\n");
}

std::string of_claim(const std::string& claim) {
  return error_with("  minimise: rms(cost)\n  subject_to: [{that: x, " + claim + "}]\n");
}

}  // namespace

TEST_CASE("An objective is an expression of reductions, each of what is recorded") {
  CHECK_THAT(of_objective("cost"),
             Contains("tune.minimise: 'cost' is no number of a run; reduce what is recorded"));
  CHECK_THAT(of_objective("3 + 4"),
             Contains("'3 + 4' has no number of a run, such as rms(x)"));
  CHECK_THAT(of_objective("rms(kost)"), Contains("'kost' is not recorded; did you mean 'cost'?"));
  CHECK_THAT(of_objective("rms(cost, a_)"), Contains("'rms' takes one expression, not 2"));
  CHECK_THAT(of_objective("quantile(cost)"), Contains("'quantile' takes two, not 1"));
  CHECK_THAT(of_objective("quantile(cost, 2)"), Contains("the share 2 is not within 0 and 1"));
  CHECK_THAT(of_objective("at(cost, 1 m)"), Contains("1 m is in m, but a time is in s"));
  CHECK_THAT(of_objective("settling_time(cost) + 1 kg"),
             Contains("tune.yaml:17:34: tune.minimise: '+' joins s and kg"));
  CHECK(of_objective("max(final(cost), min(cost where time > 0.5 s), 0) + a^2 + $a").empty());
}

TEST_CASE("A number of a block is one of an objective, unless it follows from what is tuned") {
  const auto error = [](const std::string& number) {
    return tune_error(R"(step: 10 ms
stop: 1 s
solver: rk4
parameters: {tau: {value: 1 s, above: 0 s, doc: x}}
blocks:
  lag: {block: Lag, u: 1, tau: $tau}
  other: {block: Lag, u: 1, tau: 2 s}
record: [lag, other]
tune:
  parameters: {tau: {from: 0.1 s, to: 10 s}}
  evaluations: 3
  minimise: max(lag)*)" +
                      number + "/(1 s)\n");
  };
  CHECK(error("other.tau").empty());
  CHECK(error("tau").empty());
  CHECK_THAT(error("lag.tau"), Contains("tune.minimise: 'lag.tau' follows from 'tau', which is tuned"));
}

TEST_CASE("A fault of an objective stands where it is wrong") {
  CHECK_THAT(of_objective("rms(cost) + final(kost)"), Contains("tune.yaml:17:32: tune.minimise: 'kost'"));
}

TEST_CASE("A claim that is true or false gives no margin") {
  const std::string truth = "is true or false and gives no margin; hold a number against a bound";
  CHECK_THAT(of_claim("final: cost > 1, equals: 1, within: 0.1"), Contains(truth));
  CHECK_THAT(of_claim("min: \"cost > 1 && a_ > 0\", at_least: 0.5"), Contains(truth));
  CHECK_THAT(of_claim("final: cost, equals: 1"),
             Contains("leaves no room; give 'within', or a bound at one side"));
  CHECK_THAT(of_claim("final: cost, at_most: 1, disagrees: no"),
             Contains("is to hold, so it has no 'disagrees'"));
  CHECK_THAT(of_claim("final: cost, at_most: $a"), Contains("'a' is a recorded column"));
}

TEST_CASE("Whether a loop is stable gives no margin") {
  CHECK_THAT(tune_error(R"(step: 10 ms
stop: 1 s
solver: rk4
parameters: {k: {value: 1, doc: x}}
blocks:
  error: {block: Sum, signs: "+-", u: [1, plant]}
  plant: {block: Lag, u: error, tau: 1 s, gain: $k}
record: [plant]
linear: {loop: {from: error, to: error, open: error}}
tune:
  parameters: {k: {from: 0.1, to: 100}}
  minimise: -max(plant)
  subject_to: [{that: it is stable, final: loop.stable, at_least: 1}]
)"),
             Contains("is true or false and gives no margin"));
}

TEST_CASE("Parameters, ends and methods that do not go together are refused") {
  const std::string minimise = "  minimise: rms(cost)\n";
  CHECK_THAT(error_with(minimise, "{d: {from: 0, to: 1}}"),
             Contains("tune.parameters.d: there is no parameter 'd'"));
  CHECK_THAT(error_with(minimise, "{a: {from: 3, to: 1}}"), Contains("'from: 3' is not below 'to: 1'"));
  CHECK_THAT(error_with(minimise, "{a: {from: 3, to: 4}}"),
             Contains("the start, 2, lies outside of 3 to 4; give a 'start' within"));
  CHECK_THAT(error_with(minimise, "{a: {from: 0, to: 4, scale: log}}"),
             Contains("a logarithm needs ends of one sign"));
  CHECK_THAT(error_with(minimise, "{a: {to: 4}}"), Contains("'from' is missing"));
  CHECK_THAT(error_with(minimise + "  method: bobyqa\n  subject_to: [{that: x, max: a_, at_most: 2}]\n"),
             Contains("'bobyqa' takes no claims; those of 'subject_to' need cobyla or isres"));
  CHECK_THAT(
      tune_error("sweep: {a: [1, 2]}\n" + cost_of("u1", "  parameters: {a: {from: 0, to: 3}}\n" + minimise)),
      Contains("is swept, so it is given; take it out of 'sweep' or out of 'tune'"));
}

}  // namespace stepwire::tuning
