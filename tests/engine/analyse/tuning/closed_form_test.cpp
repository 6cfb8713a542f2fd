// Tunings whose answers are closed forms.
#include <catch2/catch.hpp>
#include <cmath>

#include "tests/engine/analyse/tuning/tune_text.hpp"

namespace stepwire::tuning {

namespace {

/// The integral of t |e| of the second-order system over 30 s, from its closed step response.
double itae(double zeta) {
  const double w = std::sqrt(1.0 - zeta * zeta), step = 1e-3;
  double sum = 0.0;
  for (double t = 0.5 * step; t < 30.0; t += step)
    sum += step * t * std::abs(std::exp(-zeta * t) * (std::cos(w * t) + zeta / w * std::sin(w * t)));
  return sum;
}

/// Where a function of one minimum has it.
template <class Of>
double golden_section(double low, double high, Of of) {
  const double ratio = 0.5 * (std::sqrt(5.0) - 1.0);
  while (high - low > 1e-5) {
    const double a = high - ratio * (high - low), b = low + ratio * (high - low);
    (of(a) < of(b) ? high : low) = of(a) < of(b) ? b : a;
  }
  return 0.5 * (low + high);
}

}  // namespace

TEST_CASE("The integral of the squared error of a second-order system is least, 1, at a damping of 0.5") {
  const TuneResult result = tune_text(second_order("  minimise: final(ise)\n"));
  CHECK(result.converged);
  CHECK(result.feasible);
  CHECK(result.method == "bobyqa");
  CHECK(tuned(result, "zeta") == Approx(0.5).margin(1e-3));
  CHECK(result.objective == Approx(1.0).epsilon(1e-5));  // (1 + 4 zeta^2)/(4 zeta)
  CHECK(result.start_objective == Approx((1.0 + 4.0 * 0.81) / 3.6).epsilon(1e-5));
}

TEST_CASE("That of the squared error times time is least at the fourth root of an eighth") {
  const TuneResult result = tune_text(second_order("  minimise: final(itse)\n"));
  CHECK(tuned(result, "zeta") == Approx(std::pow(0.125, 0.25)).margin(1e-3));
  CHECK(result.objective == Approx(std::sqrt(0.5)).epsilon(1e-4));  // zeta^2 + 1/(8 zeta^2)
}

TEST_CASE("That of the absolute error times time is least where the closed step response has it") {
  const double zeta = golden_section(0.6, 0.9, itae);
  const TuneResult result = tune_text(second_order("  minimise: final(itae)\n"));
  CHECK(tuned(result, "zeta") == Approx(zeta).margin(2e-3));
  CHECK(result.objective == Approx(itae(zeta)).epsilon(1e-3));
}

TEST_CASE("A claim on the overshoot holds the damping that its closed form needs") {
  // exp(-pi zeta/sqrt(1 - zeta^2)) = 0.02, above the 0.5 that the objective alone has.
  const double log = std::log(0.02), zeta = -log / std::sqrt(log * log + M_PI * M_PI);
  const TuneResult result =
      tune_text(second_order("  minimise: final(ise)\n"
                             "  subject_to: [{that: it hardly swings, overshoot: plant, at_most: 2 %}]\n"));
  CHECK(result.method == "cobyla");
  REQUIRE(result.claims.size() == 1);
  CHECK(result.claims[0].verdict.holds);
  CHECK(result.claims[0].active);
  CHECK(result.claims[0].margin >= 0.0);
  CHECK(tuned(result, "zeta") == Approx(zeta).margin(2e-3));
}

TEST_CASE("A quadratic is least at the claim that cuts its minimum off") {
  // (a - 3)^2 + (b - 2)^2 with a + b <= 3: (2, 1), by Lagrange.
  for (const char* method : {"cobyla", "isres"}) {
    const TuneResult result =
        tune_text(cost_of("(u1 - 3)^2 + (u2 - 2)^2",
                          "  parameters: {a: {from: -5, to: 5, start: 0}, b: {from: -5, to: 5, start: 0}}\n"
                          "  minimise: final(cost)\n"
                          "  evaluations: 2000\n"
                          "  subject_to: [{that: together at most 3, final: a_ + b_, at_most: 3}]\n"
                          "  method: " +
                              std::string(method) + "\n"));
    INFO(method);
    CHECK(tuned(result, "a") == Approx(2.0).margin(0.02));
    CHECK(tuned(result, "b") == Approx(1.0).margin(0.02));
    CHECK(result.objective == Approx(2.0).margin(0.003));
    CHECK(result.claims.at(0).verdict.holds);
  }
}

TEST_CASE("What lies beyond the bounds is sought at the bound, and that is said") {
  const TuneResult result = tune_text(cost_of(
      "(u1 - 3)^2 + (u2 - 2)^2",
      "  parameters: {a: {from: 0, to: 1, start: 0.5}, b: {from: 0, to: 9}}\n  minimise: final(cost)\n"));
  CHECK(tuned(result, "a") == Approx(1.0).margin(1e-4));
  CHECK(tuned(result, "b") == Approx(2.0).margin(1e-3));
  REQUIRE(result.findings.size() == 1);
  CHECK(result.findings[0] == "a is at its upper end, beyond which the objective may fall further");
}

TEST_CASE("Over several runs the worst is least in the middle of the range, and the mean at the mean") {
  // (a - c)^2 for c = 0, 1, 5.
  const std::string tune = "  parameters: {a: {from: -9, to: 9}}\n  minimise: final(cost)\n";
  const std::string sweep = "sweep: {c: [0, 1, 5]}\n";
  const TuneResult worst = tune_text(sweep + cost_of("(u1 - u3)^2", tune));
  CHECK(tuned(worst, "a") == Approx(2.5).margin(5e-3));
  CHECK(worst.objective == Approx(6.25).epsilon(5e-3));
  const TuneResult mean = tune_text(sweep + cost_of("(u1 - u3)^2", tune + "  over: mean\n"));
  CHECK(tuned(mean, "a") == Approx(2.0).margin(2e-3));
  CHECK(mean.objective == Approx(14.0 / 3.0).epsilon(1e-4));
  CHECK(mean.runs == 3);
}

TEST_CASE("The gain at which a loop has a margin of 6 dB is the closed form's") {
  // k/(s + 1)^3 has its phase of -180 degrees at sqrt(3), where its gain is k/8.
  const TuneResult result = tune_text(R"(step: 10 ms
stop: 1 s
solver: rk4
parameters: {k: {value: 1, above: 0, doc: x}}
blocks:
  error: {block: Sum, signs: "+-", u: [1, plant]}
  gain:  {block: Gain, u: error, gain: $k}
  plant: {block: TransferFunction, u: gain, numerator: [1], denominator: [1, 3, 3, 1]}
record: [plant]
linear: {loop: {from: error, to: error, open: error}}
tune:
  parameters: {k: {from: 0.1, to: 100}}
  minimise: -max(plant)
  subject_to: [{that: twice the gain is stable, final: loop.margin.gain_db, at_least: 6.0206}]
)");
  CHECK(result.feasible);
  CHECK(tuned(result, "k") == Approx(4.0).epsilon(2e-3));
  CHECK(result.claims.at(0).verdict.value >= 6.0206);
}

}  // namespace stepwire::tuning
