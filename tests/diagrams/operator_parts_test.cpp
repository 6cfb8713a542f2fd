// Properties of the parts of the simulated operators, beyond the claims of the diagrams that use them.
#include <catch2/catch.hpp>
#include <cmath>

#include "tests/support/run_text.hpp"

using namespace stepwire;

namespace {

/// A hand that leads a free mass as heavy as itself, or what else is written as `body`.
table::Table led(const std::string& body, const std::string& keys, const std::string& stop) {
  return run_text("step: 0.5 ms\nstop: " + stop +
                  "\nsolver: rk4\nblocks:\n  hand: {diagram: ../diagrams/parts/hand.yaml, x: 0 mm, "
                  "equilibrium: [0 mm, 0 mm], position: body.position, velocity: body.velocity, " +
                  keys + "}\n" + body + "record: [body.position, hand.force, hand.push, hand.stiffness]\n");
}

const std::string mass =
    "  pull: {block: Sum, u: [hand.force, [0.27 N, 0 N]]}\n  body: {block: Mass, force: pull, mass: 0.554 "
    "kg}\n";
const std::string free_mass = "  body: {block: Mass, force: hand.force, mass: 0.554 kg}\n";

double rms(const std::vector<double>& x, std::size_t from) {
  double sum = 0.0;
  for (std::size_t k = from; k < x.size(); ++k) sum += x[k] * x[k];
  return std::sqrt(sum / static_cast<double>(x.size() - from));
}

table::Table circle(const std::string& keys) {
  return run_text(
      "step: 0.125 ms\nstop: 1.2 s\nsolver: bogacki_shampine\nblocks:\n  task: {diagram: "
      "../diagrams/parts/circle-task.yaml, subject: 5, " +
      keys +
      "}\nrecord: {every: 10 ms, signals: [task.position, task.distance, task.estimate, task.slow]}\n");
}

}  // namespace

TEST_CASE("A hand that is pulled gives way by the force over its stiffness, which rises with its force") {
  const table::Table run =
      led(mass, "noise: 0, tremor: 0 mm, rest: 100 N/m, per_force: 50 N/m/N, precision: 2", "5 s");
  CHECK(column(run, "hand.stiffness").back() == Approx(2.0 * (100.0 + 50.0 * 0.27)).epsilon(1e-4));
  CHECK(column(run, "body.position.1").back() == Approx(0.27 / 227.0).epsilon(1e-3));
  CHECK(column(run, "body.position.2").back() == Approx(0.0).margin(1e-12));
}

TEST_CASE("A free hand trembles by the tremor that is asked for") {
  // A second-order band lets through some of what is below it, and there the hand yields more.
  const table::Table run = led(free_mass, "noise: 0, tremor: 0.05 mm, precision: 1, seed: 4", "120 s");
  for (const std::string axis : {"1", "2"})
    CHECK(rms(column(run, "body.position." + axis), 2000) == Approx(0.05e-3).epsilon(0.25));
}

TEST_CASE("The force of a hand is unsteady by a share of itself") {
  // a pin that is held 20 mm from where the hand means to be: 2.7 N
  const table::Table run = run_text(R"(
step: 1 ms
stop: 100 s
solver: rk4
blocks:
  hand: {diagram: ../diagrams/parts/hand.yaml, equilibrium: [0 mm, 0 mm], position: [20 mm, 0 mm], velocity: [0 m/s, 0 m/s], x: 0 mm,
         per_force: 0 N/m/N, precision: 1, noise: 3 %, tremor: 0 mm, seed: 8}
record: {every: 10 ms, signals: [hand.force, hand.push]}
)");
  std::vector<double> along = column(run, "hand.force.1"), across = column(run, "hand.force.2");
  for (double& force : along) force += 2.7;
  // 10,000 samples: five standard errors are 3.5 %
  CHECK(rms(along, 0) == Approx(0.03 * 2.7).epsilon(0.035));
  CHECK(rms(across, 0) == Approx(0.03 * 2.7).epsilon(0.035));
}

TEST_CASE("What was learnt in the trial before is there after the rest, as far as it is not forgotten") {
  const table::Table run = circle("visual: 0, haptic: 0, slow: 2 N, break: 30 s");
  CHECK(column(run, "task.slow").front() == Approx(2.0 * std::exp(-30.0 / 75.0)));
}

TEST_CASE("What is seen has no effect before the operator begins, and has one then") {
  // on position: 0.3 s, and what the first movement needs to show
  const table::Table without = circle("visual: 0, haptic: 0"), with = circle("visual: 1, haptic: 0");
  const auto &a = column(without, "task.position.2"), &b = column(with, "task.position.2");
  for (std::size_t k = 0; k <= 30; ++k) REQUIRE(a[k] == b[k]);
  CHECK(a.back() != b.back());
  CHECK(column(without, "task.estimate.1").back() == 0.0);
}

TEST_CASE("Resistance has no effect while the hand is inside of the corridor") {
  const table::Table without = circle("visual: 1, haptic: 0, half_width: 15 mm"),
                     with = circle("visual: 1, haptic: 1, half_width: 15 mm");
  CHECK(column(without, "task.position.1") == column(with, "task.position.1"));
  CHECK(column(without, "task.position.2") == column(with, "task.position.2"));
}

TEST_CASE("Calibrated people and maps have the numbers that the page of chapter 4 prints, in both tasks") {
  const std::string of_person = "spread: 0.638, median_precision: 3.04, offset: 8 N";
  const table::Table circles = circle("law: D1, calibrated: 1"),
                     by_hand = circle("law: D1, half_width: 0.885 mm, median_aspect: 0.173, " + of_person);
  CHECK(column(circles, "task.position.1") == column(by_hand, "task.position.1"));
  CHECK(column(circles, "task.position.1") != column(circle("law: D1"), "task.position.1"));
  const auto back = [](const std::string& keys) {
    return column(
        run_text("step: 0.125 ms\nstop: 1.2 s\nsolver: bogacki_shampine\nblocks:\n  task: {diagram: "
                 "../diagrams/parts/return-task.yaml, subject: 5, law: D1, " +
                 keys + "}\nrecord: {every: 10 ms, signals: [task.position]}\n"),
        "task.position.1");
  };
  CHECK(back("calibrated: 1") == back(of_person));
  CHECK(back("calibrated: 1") != back("calibrated: 0"));
}
