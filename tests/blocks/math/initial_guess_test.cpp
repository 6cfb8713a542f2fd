// Where the search for the solution of an algebraic loop begins.
#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <cmath>

#include "tests/support/run_text.hpp"

using namespace stepwire;

namespace {

/// y = y - (y^2 - s) / 4 has the solutions sqrt(s) and -sqrt(s).
std::string square(const std::string& guess, const std::string& more = "") {
  return fmt::format(R"(step: 10 ms
stop: 1 s
algebraic_loops: solve
blocks:
  s: {{block: Ramp, slope: 3, initial: 1}}
  y: {{block: InitialGuess, u: next, guess: {}}}
  next: {{block: Expression, u: [y, s], expression: u1 - (u1^2 - u2)/4}}
{}record: [s, y]
)",
                     guess, more);
}

}  // namespace

TEST_CASE("of several solutions a loop has that near which its guess is, and follows it") {
  for (const double side : {1.0, -1.0}) {
    const table::Table run = run_text(square(side > 0.0 ? "0.7" : "-5"));
    const auto &s = column(run, "s"), &y = column(run, "y");
    for (std::size_t k = 0; k < y.size(); ++k)
      CHECK(y[k] == Approx(side * std::sqrt(s[k])).epsilon(1e-14));
  }
}

TEST_CASE("a loop is torn where it has a guess, wherever that stands in it") {
  // log(v) has no value at 0 and below; v + log(v) = u is Lambert's function of exp(u).
  const table::Table run = run_text(R"(step: 10 ms
stop: 1 s
algebraic_loops: solve
blocks:
  u: {block: Sine, bias: 1}
  v: {block: Sum, signs: "+-", u: [u, logarithm]}
  logarithm: {block: Expression, u: start, expression: log(u)}
  start: {block: InitialGuess, u: scaled, guess: 0.5}
  scaled: {block: Gain, gain: 1, u: v}
record: [u, v]
)");
  const auto &u = column(run, "u"), &v = column(run, "v");
  for (std::size_t k = 0; k < v.size(); ++k) CHECK(v[k] + std::log(v[k]) == Approx(u[k]).margin(1e-13));
}

TEST_CASE("a guess has the unit of its loop, may be a parameter, and one number stands for all elements") {
  const std::string rig = R"(step: 1 s
stop: 1 s
algebraic_loops: solve
blocks:
  v: {block: InitialGuess, u: sum, guess: GUESS}
  sum: {block: Sum, signs: "+-", u: [{value: [3, 6], unit: V}, half]}
  half: {block: Gain, gain: {value: 0.5, unit: 1}, u: v}
record: [v]
)";
  const auto with = [&](const std::string& guess) {
    std::string text = rig;
    return text.replace(text.find("GUESS"), 5, guess);
  };
  CHECK(column(run_text("parameters: {start: 2 V}\n" + with("$start")), "v.2").back() ==
        Approx(4.0).epsilon(1e-15));
  CHECK_THAT(error_of(with("2 A")), Catch::Contains("sum is in V, but v.u is in A"));
  CHECK_THAT(error_of(with("[1 V, 2 V, 3 V]")), Catch::Contains("sum.u: this has 2 elements, but others in this list have 3"));
}

TEST_CASE("outside of a loop a guess changes nothing") {
  const table::Table run = run_text(R"(step: 10 ms
stop: 1 s
blocks:
  s: {block: Sine}
  y: {block: InitialGuess, u: s, guess: 7}
record: [s, y]
)");
  CHECK(column(run, "y") == column(run, "s"));
}

TEST_CASE("a guard that resets leaves the output of a guess whose input is constant") {
  const table::Table run = run_text(R"(step: 10 ms
stop: 50 ms
blocks:
  y: {block: InitialGuess, u: 0.5, guess: 0.3, enable: {when: 1, states: reset, outputs: held}}
record: y
)");
  for (const double y : column(run, "y")) CHECK(y == 0.5);
}
