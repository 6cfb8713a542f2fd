#include <catch2/catch.hpp>

#include "engine/base/expression/expression.hpp"

namespace stepwire::expression {

namespace {

const unit::Dimension metre{{1}}, second{{0, 0, 1}}, newton{{1, 1, -2}}, pure;

/// Of variables whose units are known, in the order of their appearance.
Measure measure(const std::string& text, const std::vector<unit::Dimension>& dimensions) {
  std::vector<Measure> known;
  for (const unit::Dimension& dimension : dimensions) known.push_back({dimension, true});
  return Expression(text).measure(known);
}

std::optional<unit::Dimension> found(const std::string& text,
                                     const std::vector<unit::Dimension>& dimensions) {
  return measure(text, dimensions).dimension;
}

/// "place: message"
std::string refusal(const std::string& text, const std::vector<unit::Dimension>& dimensions) {
  try {
    measure(text, dimensions);
  } catch (const ExpressionError& error) {
    return std::to_string(error.position) + ": " + error.what();
  }
  return "none";
}

}  // namespace

TEST_CASE("the unit of an expression follows from those of its variables and numbers") {
  CHECK(found("a", {newton}) == newton);
  CHECK(found("-abs(a) + 3*b", {metre, metre}) == metre);
  CHECK(found("hypot(a, b)", {metre, metre}) == metre);
  CHECK(found("a*b", {newton, metre}) == newton * metre);
  CHECK(found("a/b - 3 mm/s", {metre, second}) == metre / second);
  CHECK(found("sqrt(a)", {metre}) == unit::power(metre, 0.5));
  CHECK(found("a^2 + b^(1/2)", {metre, unit::power(metre, 4.0)}) == unit::power(metre, 2.0));
  CHECK(found("a > b", {metre, metre}) == pure);
  CHECK(found("a > 0 ? b : -b", {metre, newton}) == newton);
  CHECK(found("atan2(a, b)", {metre, metre}) == pure);
  CHECK(found("sin(a/b)", {metre, metre}) == pure);
  CHECK(found("2 N * a", {metre}) == newton * metre);
}

TEST_CASE("a length has neither a sine nor an exponential, a time may stand for a pure number") {
  CHECK_THAT(refusal("sin(a)", {metre}), Catch::Contains("'sin' takes a pure number, and this one is in m"));
  CHECK_THAT(refusal("2 + exp(1 N)", {}), Catch::Contains("'exp' takes a pure number"));
  for (const std::string logarithm : {"log", "log2", "log10"})
    CHECK_THAT(refusal(logarithm + "(a)", {metre}), Catch::Contains("'" + logarithm + "' takes a pure number"));
  CHECK_THAT(refusal("2^a", {metre}), Catch::Contains("the exponent of '^' takes a pure number"));
  CHECK_FALSE(found("exp(-a)", {second}));
  CHECK_FALSE(found("round(a)", {metre}));
}

TEST_CASE("a bare number is of the unit that it meets in a sum") {
  CHECK(found("a + 1", {metre}) == metre);
  CHECK(found("min(1, a)", {metre}) == metre);
  CHECK_FALSE(found("2", {}));
  CHECK_FALSE(found("2*pi", {}));
}

TEST_CASE("values of different units are neither joined nor compared") {
  CHECK(refusal("a + b", {metre, newton}) == "2: '+' joins m and N; they must have the same unit");
  CHECK(refusal("2 + a - 5 s", {metre}) == "6: '-' joins m and s; they must have the same unit");
  CHECK(refusal("a > 1 && b > 2 mm", {metre, newton}) ==
        "11: '>' joins N and m; they must have the same unit");
  CHECK(refusal("(a*b)/b == b", {metre, newton}) == "8: '==' joins m and N; they must have the same unit");
  CHECK(refusal("3*max(a, b)", {metre, newton}) == "2: 'max' joins m and N; they must have the same unit");
}

TEST_CASE("both values of a choice have one unit") {
  CHECK(refusal("a > 1 ? a : b", {metre, newton}) == "0: '? :' joins m and N; they must have the same unit");
  CHECK(found("a > 1 ? a : 2 mm", {metre}) == metre);
  CHECK(found("a > 1 ? a : 0", {metre}) == metre);
  CHECK(found("a > 1 ? 0 : a", {metre}) == metre);
  CHECK(refusal("a > 1 ? 20 degC : 5 delta_degC", {metre}) != "none");
  CHECK(refusal("a > 1 ? 20 degC : 5 K", {metre}) == "none");
}

TEST_CASE("an angle per time and a number of periods per time are not added") {
  const unit::Dimension turning = unit::parse_unit("rpm")->dimension,
                        beating = unit::parse_unit("Hz")->dimension;
  CHECK(refusal("a + b", {turning, beating}) ==
        "2: a value beside '+' counts periods per time, of which each has 2*pi rad; multiply by 2*pi");
  CHECK(refusal("a - 1 rpm", {beating}) ==
        "2: a value beside '-' is an angle per time, and a period has 2*pi rad; divide by 2*pi");
  CHECK(refusal("a + 2*pi*b", {turning, beating}) == "none");
  CHECK(refusal("a + 3 1/s", {turning}) == "none");
}

TEST_CASE("a number in degC is no divisor") {
  const unit::Dimension kelvin{{0, 0, 0, 0, 1}};
  CHECK_THAT(refusal("a/1 degC", {kelvin}), Catch::Contains("1: the number in degC or degF behind '/'"));
  CHECK_THAT(refusal("1/(0.5 degF)", {}), Catch::Contains("behind '/'"));
  CHECK(refusal("a/1 delta_degC", {kelvin}) == "none");
  CHECK(refusal("a/(1 K)", {kelvin}) == "none");
  CHECK(refusal("a/(20 degC + 1 K)", {kelvin}) == "none");
}

TEST_CASE("a function of a pure number takes seconds as well, but nothing is known of its unit then") {
  CHECK_FALSE(found("exp(-a)", {second}));
  CHECK_FALSE(found("log10(abs(a))", {second}));
  CHECK(refusal("b - exp(-a)", {newton, second}) == "none");
}

TEST_CASE("a bare factor could be of any unit, so that nothing is refused with it") {
  CHECK(found("200*a", {metre}) == metre);
  CHECK_FALSE(measure("200*a", {metre}).sure);
  CHECK(refusal("b - 200*a", {newton, metre}) == "none");
  CHECK_FALSE(found("3 + 200*a", {metre}));
  CHECK(measure("a/b", {metre, second}).sure);
}

}  // namespace stepwire::expression
