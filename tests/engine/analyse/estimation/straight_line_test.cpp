// Fits whose answers a closed form gives: a straight line through eight points.
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <string>

#include "engine/simulate/codegen/generated_code.hpp"
#include "engine/simulate/run/code_trial.hpp"
#include "tests/engine/analyse/estimation/fit_text.hpp"

namespace stepwire::estimation {

namespace {

const std::string both =
    "  parameters: {slope: {start: 0.5}, bias: {start: 1}}\n"
    "  compare: [{model: model, measured: y}]\n";

// Textbook values for y = 1.1, 2.9, 5.2, 6.8, 9.1, 11.2, 12.8, 15.1 over t = 0 to 7.
// Mean t 3.5, mean y 8.025, sum (t - mean)^2 = 42, sum (t - mean)(y - mean) = 83.9.
constexpr double slope = 83.9 / 42.0, bias = 8.025 - 3.5 * slope;
constexpr double squares_of_y = 167.795;                 // sum (y - mean)^2
constexpr double squares = squares_of_y - slope * 83.9;  // of the residuals
constexpr double t_of_6 = 2.446911848791681;             // 97.5 % quantile of Student's t

}  // namespace

TEST_CASE("a straight line is fitted with the slope and bias of the textbook") {
  const FitResult result = fit_text(straight_line(both));
  CHECK(result.converged);
  CHECK(found(result, "slope").value == Approx(slope).epsilon(1e-9));
  CHECK(found(result, "bias").value == Approx(bias).epsilon(1e-8));
  CHECK(result.cost == Approx(0.5 * squares).epsilon(1e-8));
  CHECK(result.freedom == 6.0);
}

TEST_CASE("standard errors, intervals and the correlation are those of the textbook") {
  const FitResult result = fit_text(straight_line(both));
  const double deviation = std::sqrt(squares / 6.0);
  const double error = deviation / std::sqrt(42.0),
               level = deviation * std::sqrt(1.0 / 8.0 + 3.5 * 3.5 / 42.0);
  CHECK(result.deviation == Approx(deviation).epsilon(1e-7));
  const FittedNumber &steep = found(result, "slope"), &flat = found(result, "bias");
  CHECK(steep.standard_error == Approx(error).epsilon(1e-6));
  CHECK(flat.standard_error == Approx(level).epsilon(1e-6));
  CHECK(steep.high - steep.value == Approx(t_of_6 * error).epsilon(1e-6));
  CHECK(flat.value - flat.low == Approx(t_of_6 * level).epsilon(1e-6));
  CHECK(result.correlation(0, 1) == Approx(-3.5 / std::sqrt(3.5 * 3.5 + 42.0 / 8.0)).epsilon(1e-6));
}

TEST_CASE("two records share a slope and have a bias each, as in an analysis of covariance") {
  // Least squares of y = slope t + bias_i. S_tt = sum (t - mean t)^2 and S_ty = sum (t - mean t)(y - mean y)
  // of each record are added: slope = S_ty / S_tt. Then bias_i = mean y_i - slope mean t.
  const std::array<std::array<double, 8>, 2> y{
      {{1.1, 2.9, 5.2, 6.8, 9.1, 11.2, 12.8, 15.1}, {4.2, 5.7, 8.1, 10.3, 11.6, 14.2, 15.9, 18.3}}};
  std::array<double, 2> mean{};
  double products = 0.0, squares_of_both = 0.0;
  for (std::size_t i = 0; i < y.size(); ++i) {
    for (const double one : y[i]) mean[i] += one / 8.0;
    for (std::size_t t = 0; t < 8; ++t) products += (static_cast<double>(t) - 3.5) * (y[i][t] - mean[i]);
  }
  const double both_slope = products / 84.0;
  for (std::size_t i = 0; i < y.size(); ++i)
    for (std::size_t t = 0; t < 8; ++t) {
      const double rest = y[i][t] - mean[i] - both_slope * (static_cast<double>(t) - 3.5);
      squares_of_both += rest * rest;
    }
  const double deviation = std::sqrt(squares_of_both / 13.0);
  std::string text = straight_line(
      "  parameters: {slope: {start: 0.5}, bias: {start: 1, each_record: true}}\n"
      "  compare: [{model: model, measured: seen}]\n");
  text.replace(
      text.find("record: [model, y,"), 18,
      "  second: {block: LookupTable, u: t, points: [0, 1, 2, 3, 4, 5, 6, 7], values: [4.2, 5.7, 8.1, 10.3, "
      "11.6, 14.2, 15.9, 18.3]}\n  seen: {block: Expression, u: [y, second], expression: "
      "\"$trial == 1 ? u1 : u2\"}\nsweep: {trial: [1, 2]}\nrecord: [model, seen,");
  text.replace(text.find("parameters:\n"), 12, "parameters:\n  trial: {value: 1, doc: which record}\n");
  const FitResult result = fit_text(text);
  CHECK(result.converged);
  CHECK(result.freedom == 13.0);
  CHECK(result.deviation == Approx(deviation).epsilon(1e-7));
  CHECK(found(result, "slope").value == Approx(both_slope).epsilon(1e-9));
  CHECK(found(result, "slope").standard_error == Approx(deviation / std::sqrt(84.0)).epsilon(1e-6));
  const std::array<std::string, 2> names{"bias of 1", "bias of 2"};
  for (std::size_t i = 0; i < names.size(); ++i) {
    CHECK(found(result, names[i]).value == Approx(mean[i] - 3.5 * both_slope).epsilon(1e-8));
    CHECK(found(result, names[i]).standard_error ==
          Approx(deviation * std::sqrt(1.0 / 8.0 + 3.5 * 3.5 / 84.0)).epsilon(1e-6));
  }
}

TEST_CASE("a free offset does what a fitted bias does") {
  const FitResult result =
      fit_text(straight_line("  parameters: {slope: {start: 0.5}}\n"
                             "  compare: [{model: steep, measured: y, offset: free}]\n"));
  CHECK(found(result, "slope").value == Approx(slope).epsilon(1e-9));
  CHECK(result.freedom == 6.0);
  CHECK(found(result, "slope").standard_error == Approx(std::sqrt(squares / 6.0 / 42.0)).epsilon(1e-6));
  CHECK(result.records.at(0).comparisons.at(0).agreement ==
        Approx(100.0 * (1.0 - std::sqrt(squares / squares_of_y))).epsilon(1e-9));
}

TEST_CASE("weights count as so many equal rows would") {
  // Twice the weight, four times the row: t = 7 alone has weight 2.
  const FitResult result =
      fit_text(straight_line("  parameters: {slope: {start: 0.5}, bias: {start: 1}}\n"
                             "  compare: [{model: model, measured: y, weight: \"time == 7 ? 2 : 1\"}]\n"));
  const double n = 11.0, st = 28.0 + 21.0, sy = 64.2 + 45.3, stt = 140.0 + 147.0, sty = 308.6 + 317.1;
  CHECK(found(result, "slope").value == Approx((n * sty - st * sy) / (n * stt - st * st)).epsilon(1e-8));
}

TEST_CASE("rows that where leaves out do not count") {
  const FitResult result =
      fit_text(straight_line("  parameters: {slope: {start: 0.5}, bias: {start: 1}}\n"
                             "  compare: [{model: model, measured: y, where: time > 4 || time == 0}]\n"));
  // t = 0, 5, 6, 7 with y = 1.1, 11.2, 12.8, 15.1
  CHECK(found(result, "slope").value ==
        Approx((238.5 - 18 * 40.2 / 4) / (110 - 18 * 18 / 4.0)).epsilon(1e-8));
}

TEST_CASE("a bound holds, and it is said which") {
  const FitResult result =
      fit_text(straight_line("  parameters: {slope: {start: 1, bounds: [0, 1.5]}, bias: {start: 1}}\n"
                             "  compare: [{model: model, measured: y}]\n"));
  CHECK(found(result, "slope").value == Approx(1.5));
  CHECK(found(result, "slope").at_bound);
  REQUIRE(!result.findings.empty());
  CHECK_THAT(result.findings.front(), Catch::Contains("slope is at its upper bound"));
}

TEST_CASE("a robust loss takes less from a row that is far off") {
  const std::string far = [] {
    std::string text = straight_line(
        "  parameters: {slope: {start: 0.5}, bias: {start: 1}}\n"
        "  compare: [{model: model, measured: y}]\n");
    return text.replace(text.find("15.1]"), 5, "35.1]");
  }();
  const double plain = found(fit_text(far), "slope").value;
  for (const std::string loss : {"huber", "cauchy"}) {
    INFO(loss);
    const double robust = found(fit_text(far + "  loss: " + loss + "\n  width: 0.2\n"), "slope").value;
    CHECK(plain > 3.0);
    CHECK(std::abs(robust - slope) < 0.05);
  }
}

TEST_CASE("compiled runs give what interpreted ones give, at any number of threads") {
  codegen::GeneratedCode code{run::code_trial()};
  FitOptions one, three;
  one.threads = 1;
  three.threads = 3;
  const FitResult compiled = fit_text(straight_line(both), &code, one);
  CHECK(compiled.compiled);
  CHECK(found(compiled, "slope").value == Approx(slope).epsilon(1e-9));
  CHECK(found(compiled, "bias").value == Approx(bias).epsilon(1e-8));
  const FitResult again = fit_text(straight_line(both), &code, three);
  CHECK(found(again, "slope").value == found(compiled, "slope").value);
  CHECK(found(again, "bias").standard_error == found(compiled, "bias").standard_error);
}

TEST_CASE(
    "a number that follows a parameter in no straight line costs a plan for each run, but no compilation") {
  codegen::GeneratedCode code{run::code_trial()};
  std::string text = straight_line(both);
  const std::string gain = "gain: $slope";
  REQUIRE(text.find(gain) != std::string::npos);
  text.replace(text.find(gain), gain.size(), "gain: = exp(slope) - 1");
  const FitResult compiled = fit_text(text, &code), interpreted = fit_text(text);
  CHECK(compiled.compiled);
  CHECK(!interpreted.compiled);
  CHECK(found(compiled, "slope").value == Approx(std::log(1.0 + slope)).epsilon(1e-8));
  CHECK(found(compiled, "slope").value == found(interpreted, "slope").value);
  CHECK(found(compiled, "bias").standard_error == found(interpreted, "bias").standard_error);
}

}  // namespace stepwire::estimation
