#include <catch2/catch.hpp>

#include "tests/engine/analyse/estimation/fit_text.hpp"

namespace stepwire::estimation {
using Catch::Contains;
using Catch::StartsWith;

namespace {

std::string error_of_fit(const std::string& fit) {
  return fit_error(straight_line(fit));
}

const std::string compare = "  compare: [{model: model, measured: y}]\n";

}  // namespace

TEST_CASE("a parameter that is not there is told with its place and what would be right") {
  const std::string error = error_of_fit("  parameters: {slop: {start: 1}, bias: {}}\n" + compare);
  CHECK_THAT(error, StartsWith("fit.yaml:16:16: fit.parameters.slop: "));
  CHECK_THAT(error, Contains("there is no parameter 'slop'; did you mean 'slope'?"));
}

TEST_CASE("bounds the wrong way round and a start outside of them are refused") {
  CHECK_THAT(error_of_fit("  parameters: {slope: {start: 1, bounds: [3, 2]}}\n" + compare),
             Contains("the bounds are the wrong way round: 3 is not below 2"));
  CHECK_THAT(error_of_fit("  parameters: {slope: {start: 1, bounds: [2, 3]}}\n" + compare),
             Contains("the start, 1, is outside of the bounds [2, 3]"));
  CHECK_THAT(error_of_fit("  parameters: {slope: {start: 1, bounds: 2}}\n" + compare),
             Contains("bounds are a lower and an upper one"));
}

TEST_CASE("the scale of a temperature is a difference") {
  CHECK_THAT(error_of_fit("  parameters: {slope: {start: 20 degC, scale: 1 degC}}\n" + compare),
             Contains("1 degC is a temperature, but a difference of temperatures is meant; write it in K"));
}

TEST_CASE("a parameter that moves nothing is refused") {
  const std::string error = error_of_fit(
      "  parameters: {slope: {start: 1}, bias: {start: 1}}\n"
      "  compare: [{model: steep, measured: y}]\n");
  CHECK_THAT(error, StartsWith("fit.yaml:16:"));
  CHECK_THAT(error, Contains("fit.parameters.bias: moves nothing that is compared; take it out of the fit"));
}

TEST_CASE("what is compared must be recorded") {
  CHECK_THAT(error_of_fit("  parameters: {slope: {start: 1}}\n"
                          "  compare: [{model: modell, measured: y}]\n"),
             Contains("'modell' is not recorded; did you mean 'model'?"));
  CHECK_THAT(error_of_fit("  parameters: {slope: {start: 1}}\n"
                          "  compare: [{model: model}]\n"),
             Contains("'measured' is missing"));
  CHECK_THAT(error_of_fit("  parameters: {slope: {start: 1}}\n"),
             Contains("'compare' is missing (model and measurement, side by side)"));
}

TEST_CASE("a condition that selects no row, and too few rows, are refused") {
  CHECK_THAT(error_of_fit("  parameters: {slope: {start: 1}}\n"
                          "  compare: [{model: model, measured: y, where: time > 100}]\n"),
             Contains("'time > 100' selects no row"));
  CHECK_THAT(error_of_fit("  parameters: {slope: {start: 1}, bias: {}}\n"
                          "  compare: [{model: model, measured: y, where: time < 2}]\n"),
             Contains("2 rows are compared, too few for 2 unknown numbers"));
}

TEST_CASE("a row that is no number is told with its time") {
  CHECK_THAT(error_of_fit("  parameters: {slope: {start: 1}}\n"
                          "  compare: [{model: model, measured: sqrt(3 - y)}]\n"),
             Contains("'sqrt(3 - y)' is ") && Contains("nan at 2 s; leave such rows out by 'where'"));
}

TEST_CASE("words that nobody knows are refused with those that are known") {
  CHECK_THAT(
      error_of_fit("  parameters: {slope: {start: 1}}\n" + compare + "  loss: hubert\n"),
      Contains("fit.loss: 'hubert' is not allowed; did you mean 'huber'? It is one of: none, huber, cauchy"));
  CHECK_THAT(error_of_fit("  parameters: {slope: {begin: 1}}\n" + compare), Contains("it has no 'begin'"));
  CHECK_THAT(error_of_fit("  parameters: {slope: {start: 1}}\n" + compare + "  start: 8\n"),
             Contains("the fit has no 'start'; did you mean 'starts'?"));
  CHECK_THAT(error_of_fit("  parameters: {slope: {start: 1}}\n" + compare + "  starts: 0\n"),
             Contains("'0' is no whole number from 1 to 10000"));
}

TEST_CASE("units must fit") {
  CHECK_THAT(error_of_fit("  parameters: {slope: {start: 1 N, bounds: [1 m, 2 m]}}\n" + compare),
             Contains("1 m is in m, but the parameter is in N"));
}

TEST_CASE("what is held out must be told by swept parameters, and something must be left") {
  CHECK_THAT(error_of_fit("  parameters: {slope: {start: 1}}\n" + compare + "  hold_out: y > 3\n"),
             Contains("'y' is no swept parameter"));
  CHECK_THAT(error_of_fit("  parameters: {slope: {start: 1}}\n" + compare + "  hold_out: 1\n"),
             Contains("holds out every record"));
}

}  // namespace stepwire::estimation
