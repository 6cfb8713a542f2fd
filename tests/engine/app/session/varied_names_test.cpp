#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <string>
#include <vector>

#include "blocks/register.hpp"
#include "engine/app/session/session.hpp"
#include "tests/engine/app/cli/small_study.hpp"

namespace stepwire::session {
using Catch::Contains;

namespace {

/// A constant that is 2 mm above a wall, and a parameter that follows from the wall.
std::string walls(const std::string& more, const std::string& sweep = "{wall: [1 mm, 2 mm]}") {
  return "stepwire: 1\ntitle: t\nstep: 10 ms\nstop: 1 s\nsolver: rk4\n"
         "parameters:\n  wall: 5 mm\n  other: 3 mm\n  double: = 2*wall\n"
         "blocks:\n  x: {block: Constant, value: = double + 2 mm}\n  y: {block: Constant, value: $other}\n"
         "  l: {block: Lag, u: y, tau: = 1 s*wall/(1 mm)}\n  k: {block: Lag, u: y, tau: 2 s}\n"
         "record: [x, y]\nsweep: " +
         sweep + "\n" + more;
}

std::string answer_of(const std::string& text) {
  const Scratch folder;
  folder.file("t.yaml", text);
  try {
    static const Registry registry = blocks();
    Session session(registry);
    session.load(folder.path("t.yaml"));
  } catch (const yaml::Error& error) {
    return error.what();
  }
  return "was taken";
}

std::string claim(const std::string& text) {
  return walls("claims:\n  - {that: a, " + text + "}\n");
}

/// Labels of the curves of the first figure of a file with a sweep.
std::vector<std::string> labels_of(const std::string& text) {
  const Scratch folder;
  folder.file("t.yaml", text);
  static const Registry registry = blocks();
  Session session(registry);
  const LoadedModel model = session.load(folder.path("t.yaml"));
  const query::Series& by = *model.figures.at(0).panels.at(0).find("by");
  return {by.unit_text, fmt::format("{:.12g}", by.unit.from_si(0.001))};
}

}  // namespace

TEST_CASE("the number of a block that a sweep sets is labelled in the unit of the file") {
  const auto file = [](const std::string& value, const std::string& values) {
    return "stepwire: 1\ntitle: t\nstep: 10 ms\nstop: 1 s\nblocks:\n  x: {block: Constant, value: " + value +
           "}\nrecord: x\nsweep: {x.value: " + values +
           "}\nfigure: {plot: lines, x: time, y: x, by: x.value}\n";
  };
  CHECK(labels_of(file("5 mm", "[1 mm, 2 mm]")) == std::vector<std::string>{"mm", "1"});
  CHECK(labels_of(file("5 mm", "{from: 1 mm, to: 2 mm, count: 3}")) == std::vector<std::string>{"mm", "1"});
  CHECK(labels_of(file("5", "[1, 2]")) == std::vector<std::string>{"", "0.001"});
}

TEST_CASE("a claim, a figure or a kept number takes no single value of a parameter that a sweep varies") {
  const std::string swept =
      "'wall' is swept, and the value of the file need not occur in any run; write wall";
  CHECK_THAT(answer_of(claim("max: x, at_most: $wall")), Contains(swept));
  CHECK_THAT(answer_of(claim("max: x - $wall, at_most: 0 mm")),
             Contains("t.yaml:18:24: claims") && Contains(swept));
  CHECK_THAT(answer_of(claim("fraction: x <= $wall, at_least: 1")), Contains(swept));
  CHECK_THAT(answer_of(claim("fraction_of_runs: max(x) < $wall, at_least: 1")), Contains(swept));
  CHECK_THAT(answer_of(claim("final: x, equals: $wall, within: 1 mm")), Contains(swept));
  CHECK_THAT(answer_of(walls("figure: {plot: lines, x: time in s, y: x - $wall in mm}\n")), Contains(swept));
  CHECK_THAT(answer_of(walls("figure: {plot: lines, x: time in s, y: x in mm, reference: $wall}\n")),
             Contains(swept));
  CHECK_THAT(answer_of(walls("", "{wall: [1 mm, 2 mm], keep: {over: max(x - $wall)}}")), Contains(swept));
  CHECK_THAT(answer_of(walls("claims: [{that: a, max: x - $wall, at_most: 0 mm}]\n",
                             "{wall: {uniform: [1 mm, 2 mm]}, design: {samples: 3, seed: 1}}")),
             Contains(swept));
}

TEST_CASE("what follows from a swept parameter is refused with its formula") {
  const std::string follows =
      "'double' follows from 'wall', which is swept, so that it has no single value; record it, or write its "
      "formula with "
      "the column wall: 2*wall";
  CHECK_THAT(answer_of(claim("max: abs(x - $double), at_most: 1 um")), Contains(follows));
  CHECK_THAT(answer_of(claim("max: abs(x - double), at_most: 1 um")), Contains(follows));
  CHECK_THAT(answer_of(claim("max: time - l.tau, at_most: 1 s")),
             Contains("'l.tau' follows from 'wall', which is swept"));
}

TEST_CASE("columns of swept parameters and the parameters that no sweep varies are taken") {
  CHECK(answer_of(claim("max: abs(x - 2*wall), at_most: 3 mm")) == "was taken");
  CHECK(answer_of(claim("max: x - $other, at_most: 9 mm")) == "was taken");
  CHECK(answer_of(claim("max: y, at_most: $other")) == "was taken");
  CHECK(answer_of(claim("max: time - k.tau, at_most: 1 s")) == "was taken");
}

TEST_CASE("a fit compares with no number that it changes") {
  const auto fit = [](const std::string& model, const std::string& more = "") {
    return "stepwire: 1\ntitle: t\nstep: 10 ms\nstop: 1 s\nparameters:\n  k: 2\n  twice: = 2*k\n"
           "blocks:\n  x: {block: Constant, value: $k}\n  y: {block: Constant, value: 3}\n  z: {block: "
           "Constant, value: $twice}\nrecord: [x, y]\n"
           "fit: {parameters: {k: {start: 1}}, compare: [{model: " +
           model + ", measured: y}]" + more + "}\n";
  };
  CHECK(answer_of(fit("x")) == "was taken");
  CHECK_THAT(answer_of(fit("x*$k")), Contains("'k' is found by the fit"));
  CHECK_THAT(answer_of(fit("x*$twice")), Contains("'twice' follows from 'k', which is found by the fit"));
  CHECK(answer_of(fit("x", ", curves: [{y: k*i, over: {i: [0, 1]}}]")) == "was taken");
  CHECK_THAT(answer_of(fit("x", ", curves: [{y: twice*i, over: {i: [0, 1]}}]")),
             Contains("'twice' follows from 'k'"));
}

}  // namespace stepwire::session
