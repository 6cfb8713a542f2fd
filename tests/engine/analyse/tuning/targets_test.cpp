// Tunings toward values, whose answers are closed forms.
#include <atomic>
#include <catch2/catch.hpp>
#include <cmath>

#include "tests/engine/analyse/tuning/tune_text.hpp"

namespace stepwire::tuning {

namespace {

std::string with_targets(const std::string& targets) {
  return cost_of("u1",
                 "  parameters: {a: {from: -5, to: 5, start: 0}, b: {from: -5, to: 5, start: 0}}\n"
                 "  toward:\n" +
                     targets);
}

constexpr const char* sum = "    - {that: the sum, final: a_ + b_, equals: 3, within: 0.5}\n";
constexpr const char* difference = "    - {that: the difference, final: a_ - b_, equals: 1, within: 0.1}\n";

}  // namespace

TEST_CASE("Two targets of two numbers are met, and tell both as their deviations allow") {
  const TuneResult result = tune_text(with_targets(std::string(sum) + difference));
  CHECK(tuned(result, "a") == Approx(2.0).margin(0.01));
  CHECK(tuned(result, "b") == Approx(1.0).margin(0.01));
  CHECK(result.objective == Approx(0.0).margin(1e-3));
  CHECK(result.start_objective == Approx(36.0 + 100.0));  // (3/0.5)^2 + (1/0.1)^2
  REQUIRE(result.targets.size() == 2);
  CHECK(result.targets[0].start == Approx(-6.0));
  CHECK(result.targets[1].start == Approx(-10.0));
  // By shares of ten: the sum changes by 20 of its deviations with each, the difference by 100 and -100.
  REQUIRE(result.resolution.singular_values.size() == 2);
  CHECK(result.resolution.singular_values[0] == Approx(100.0 * std::sqrt(2.0)));
  CHECK(result.resolution.singular_values[1] == Approx(20.0 * std::sqrt(2.0)));
  // a is half of sum and difference together: its deviation is hypot(0.5, 0.1)/2.
  for (const TunedNumber& number : result.numbers) {
    REQUIRE(number.interval);
    CHECK((*number.interval)[1] - number.value == Approx(1.96 * std::hypot(0.5, 0.1) / 2.0).epsilon(1e-6));
    CHECK(number.value - (*number.interval)[0] == Approx(1.96 * std::hypot(0.5, 0.1) / 2.0).epsilon(1e-6));
  }
}

TEST_CASE("Targets that cannot be met together share what they are off by their deviations") {
  // The least (a - 1)^2/0.2^2 + (a - 2)^2/0.4^2 is at (1/0.04 + 2/0.16)/(1/0.04 + 1/0.16) = 1.2.
  const TuneResult result = tune_text(cost_of("u1",
                                              "  parameters: {a: {from: -5, to: 5, start: 0}}\n"
                                              "  toward:\n"
                                              "    - {that: one, final: a_, equals: 1, within: 0.2}\n"
                                              "    - {that: two, final: a_, equals: 2, within: 0.4}\n"));
  CHECK(tuned(result, "a") == Approx(1.2).margin(0.01));
  CHECK(result.objective == Approx(1.0 + 4.0).epsilon(1e-3));
}

TEST_CASE("A direction that no target tells is free, and its numbers have no interval") {
  const TuneResult result = tune_text(with_targets(sum));
  CHECK(tuned(result, "a") + tuned(result, "b") == Approx(3.0).margin(0.01));
  REQUIRE(result.resolution.singular_values.size() == 2);
  CHECK(result.resolution.singular_values[0] == Approx(20.0 * std::sqrt(2.0)));
  CHECK(result.resolution.singular_values[1] == Approx(0.0).margin(1e-9));
  CHECK_FALSE(result.numbers[0].interval);
  CHECK_FALSE(result.numbers[1].interval);
  REQUIRE_FALSE(result.findings.empty());
  CHECK_THAT(result.findings.front(), Catch::Contains("0.71 a") && Catch::Contains("-0.71 "));
}

TEST_CASE("An interruption keeps the best point toward targets so far, and no resolution") {
  std::atomic<bool> interrupt = false;
  int calls = 0;
  const TuneOptions options{.threads = 1, .progress = [&](double, const std::string&) {
                              if (++calls == 4) interrupt = true;
                            }};
  const TuneResult result =
      tune_text(with_targets(std::string(sum) + difference), nullptr, options, &interrupt);
  CHECK(result.interrupted);
  CHECK(result.history.size() == 4);
  CHECK(result.objective <= result.start_objective);
  CHECK(result.resolution.singular_values.empty());
}

TEST_CASE("A tuning has an objective or targets, each of which equals a value within a deviation") {
  const auto error = [](const std::string& rest) {
    return tune_error(cost_of("u1", "  parameters: {a: {from: -1, to: 3}}\n" + rest));
  };
  using Catch::Contains;
  CHECK_THAT(error(""), Contains("'minimise' is missing, or 'toward'"));
  CHECK_THAT(error("  minimise: rms(cost)\n  toward: [{that: x, final: a_, equals: 1, within: 1}]\n"),
             Contains("a tuning has 'minimise' or 'toward', not both"));
  CHECK_THAT(error("  toward: [{that: x, final: a_, at_most: 1}]\n"),
             Contains("is a target, which 'equals' a value 'within' the deviation"));
  CHECK_THAT(error("  toward: [{that: x, final: a_, equals: 1, within: 0}]\n"), Contains("leaves no room"));
  CHECK_THAT(error("  toward: [{that: x, final: d_, equals: 1, within: 0.1}]\n"),
             Contains("'d_' is not recorded"));
}

}  // namespace stepwire::tuning
