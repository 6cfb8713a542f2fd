#include "engine/analyse/linear/trim.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "tests/support/plan_text.hpp"

namespace stepwire::linear {

namespace {

TrimResult trimmed(const std::string& yaml, TrimRequest request) {
  const DiagramFolder folder;
  folder.write("a.yaml", "stepwire: 1\ntitle: x\nstop: 3 s\n" + yaml);
  diagram::Loader loader(library());
  return trim(loader.load(folder.path("a.yaml")), request);
}

TrimEntry entry(const std::string& name, std::optional<double> fixed = {}) {
  TrimEntry one;
  one.name.name = name;
  one.fixed = fixed;
  return one;
}

}  // namespace

TEST_CASE("two tanks stand still at the levels at which as much flows out as in") {
  // q = c sqrt(h) of each: the level of both is (q/c)^2.
  const TrimResult found = trimmed(R"(step: 10 ms
solver: rk4
blocks:
  in: {block: Constant, value: 0.3}
  out1: {block: Expression, u: upper, expression: 0.5*sqrt(abs(u1))}
  out2: {block: Expression, u: lower, expression: 0.2*sqrt(abs(u1))}
  d1: {block: Sum, signs: "+-", u: [in, out1]}
  d2: {block: Sum, signs: "+-", u: [out1, out2]}
  upper: {block: Integrator, u: d1, initial: 1}
  lower: {block: Integrator, u: d2, initial: 1}
)",
                                   {});
  CHECK(found.converged);
  CHECK(found.states[0].value == Approx(0.36).epsilon(1e-8));
  CHECK(found.states[1].value == Approx(2.25).epsilon(1e-8));
  CHECK(found.states[0].setting == "upper.initial");
}

TEST_CASE("an input is found for an output that is given, within its bounds") {
  const std::string solver = GENERATE("rk4", "radau", "{name: dormand_prince, relative: 1e-8}");
  const std::string yaml = "step: 10 ms\nsolver: " + solver + R"(
blocks:
  u: {block: Constant, value: 1}
  y: {block: Lag, u: u, gain: 3, tau: 1 s}
)";
  TrimRequest request;
  request.inputs = {entry("u")};
  request.outputs = {entry("y", 6.0)};
  const TrimResult found = trimmed(yaml, request);
  CHECK(found.converged);
  CHECK(found.inputs[0].value == Approx(2.0).epsilon(1e-9));
  CHECK(found.inputs[0].setting == "u.value");
  request.inputs[0].upper = 1.5;
  const TrimResult bounded = trimmed(yaml, request);
  CHECK_FALSE(bounded.converged);
  CHECK(bounded.inputs[0].at_bound);
}

TEST_CASE("a state may be given, and go on changing") {
  TrimRequest request;
  request.states = {entry("x.x", 2.0), entry("v.x", 0.5)};
  request.states[0].steady = false;
  request.inputs = {entry("f")};
  const TrimResult found = trimmed(R"(step: 10 ms
solver: rk4
blocks:
  f: {block: Constant, value: 0}
  a: {block: Expression, u: [f, v], expression: u1 - 0.2*u2}
  v: {block: Integrator, u: a}
  x: {block: Integrator, u: v}
)",
                                   request);
  CHECK(found.converged);
  CHECK(found.inputs[0].value == Approx(0.1).epsilon(1e-9));
}

TEST_CASE("a sampled loop stands still where it is the same a base period later") {
  const TrimResult found = trimmed(R"(step: 1 ms
solver: rk4
blocks:
  r: {block: Constant, value: 2}
  e: {block: Sum, signs: "+-", u: [r, plant], every: 10 ms}
  pid: {block: DiscretePID, u: e, kp: 1, ki: 2 1/s, every: 10 ms}
  plant: {block: Lag, u: pid, gain: 4, tau: 0.3 s}
)",
                                   {});
  CHECK(found.converged);
  CHECK(found.states[0].channel.name == "plant.x");
  CHECK(found.states[0].value == Approx(2.0).epsilon(1e-7));
}

TEST_CASE("numbers that the conditions leave open are counted") {
  const std::string yaml = R"(step: 10 ms
solver: rk4
blocks:
  f: {block: Constant, value: 3}
  a: {block: Expression, u: [f, x, v], expression: u1 - 1e6*u2 - 0.2*u3}
  v: {block: Integrator, u: a}
  x: {block: Integrator, u: v}
)";
  CHECK(trimmed(yaml, {}).undetermined == 0);
  TrimRequest request;
  request.inputs = {entry("f")};
  CHECK(trimmed(yaml, request).undetermined == 1);
  request.outputs = {entry("x", 1e-6)};
  CHECK(trimmed(yaml, request).undetermined == 0);
  std::string drifting = yaml;
  drifting.replace(drifting.find(" - 1e6*u2"), 9, " - 0*u2");
  CHECK(trimmed(drifting, {}).converged == false);
  request.outputs.clear();
  const TrimResult anywhere = trimmed(drifting, request);
  CHECK(anywhere.converged);
  CHECK(anywhere.undetermined == 1);
}

}  // namespace stepwire::linear
