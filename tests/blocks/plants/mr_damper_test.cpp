#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <cmath>

#include "tests/support/run_text.hpp"

using namespace stepwire;

namespace {

/// Force of the RD-1097-01 after a long steady motion, by either integration.
double steady_force(const std::string& speed, const std::string& current, const std::string& more = "") {
  const table::Table table = run_text(
      "step: 0.1 ms\nstop: 1 s\nsolver: rk4\nblocks:\n  damper: {block: MRDamper, preset: rd-1097-01, "
      "velocity: " +
      speed + ", current: " + current + more + "}\nrecord: [damper.force]\n");
  return column(table, "damper.force").back();
}

/// A sine of 4 mm and 4 Hz with a current that is switched while z is stored; `power` integrates (c v + alpha
/// z) v.
std::string exercise(const std::string& integration, const std::string& step) {
  return "step: " + step + R"(
stop: 1 s
solver: rk4
blocks:
  velocity: {block: Sine, amplitude: 0.1005 m/s, frequency: 4 Hz, phase: 1.0}
  current:  {block: Pulse, amplitude: 0.35 A, period: 0.14 s, width: 0.5, every: 1 ms}
  damper:   {block: MRDamper, velocity: velocity, current: current, initial: 2 mm, integration: )" +
         integration + R"(}
  power:    {block: Product, u: [damper.force, velocity]}
  work:     {block: Integrator, u: power}
record: [velocity, damper.force, damper.z, damper.dissipated, damper.stored, damper.switching_work, work]
)";
}

double imbalance(const table::Table& table) {
  const auto& work = column(table, "work");
  double worst = 0.0;
  for (std::size_t k = 0; k < work.size(); ++k) {
    const double rise = column(table, "damper.stored")[k] - column(table, "damper.stored")[0];
    const double account =
        rise + column(table, "damper.dissipated")[k] - column(table, "damper.switching_work")[k];
    worst = std::max(worst, std::abs(work[k] - account));
  }
  return worst / work.back();
}

}  // namespace

TEST_CASE("The linear damper reaches the forces that follow from the published numbers") {
  // alpha(i) A/(beta+gamma) + c(i) v with eq. 4-6 in mm, evaluated by hand: 2.969 + 2.0 N and 34.31 + 9.92 N.
  const double z = 36.2095 / (10.6140 - 7.0773);
  CHECK(steady_force("100 mm/s", "0 A") == Approx(0.29 * z + 0.02 * 100.0).epsilon(1e-9));
  const double i = 0.35;
  const double alpha = 72.8 * i * i * i - 42.88 * i * i + 14.83 * i + 0.29;
  const double c = -9.37 * i * i * i * i + 10.22 * i * i * i - 4.33 * i * i + 0.89 * i + 0.02;
  CHECK(steady_force("-100 mm/s", "0.35 A") == Approx(-(alpha * z + c * 100.0)).epsilon(1e-9));
}

TEST_CASE("Outside its identified currents the damper keeps the coefficients of the nearer end") {
  CHECK(steady_force("100 mm/s", "1 A") == steady_force("100 mm/s", "0.35 A"));
  CHECK(steady_force("100 mm/s", "-0.2 A") == steady_force("100 mm/s", "0 A"));
}

TEST_CASE("Raw extrapolation evaluates the polynomials wherever the current is") {
  // At 1 A and 250 mm/s the viscous part is -2.58 N s/mm times 250 mm/s; it feeds energy in.
  // 250 mm/s.
  const double z = 36.2095 / (10.6140 - 7.0773);
  const double wanted = (72.8 - 42.88 + 14.83 + 0.29) * z + (-9.37 + 10.22 - 4.33 + 0.89 + 0.02) * 250.0;
  CHECK(wanted == Approx(-181.0).epsilon(0.01));
  CHECK(steady_force("250 mm/s", "1 A", ", extrapolate: raw") == Approx(wanted).epsilon(1e-9));
}

TEST_CASE("Work, stored, dissipated and switching work of a damper balance by both integrations") {
  CHECK(imbalance(run_text(exercise("solver", "0.1 ms"))) < 1e-6);
  CHECK(imbalance(run_text(exercise("exact", "0.1 ms"))) < 1e-4);
}

TEST_CASE("The energy account of the exact step is of second order while the current changes") {
  const auto run = [](const std::string& integration, const std::string& step) {
    return run_text("step: " + step + R"(
stop: 0.5 s
solver: rk4
blocks:
  velocity: {block: Sine, amplitude: 0.1 m/s, frequency: 4 Hz, phase: 1.0}
  current:  {block: Sine, amplitude: 0.1 A, frequency: 3 Hz, bias: 0.17 A}
  damper:   {block: MRDamper, velocity: velocity, current: current, integration: )" +
                    integration + R"(}
record: [damper.dissipated, damper.stored, damper.switching_work]
)");
  };
  const table::Table fine = run("solver", "0.02 ms");
  for (const char* name : {"damper.dissipated", "damper.switching_work"}) {
    const double right = column(fine, name).back();
    const double coarse = std::abs(column(run("exact", "2 ms"), name).back() - right);
    const double halved = std::abs(column(run("exact", "1 ms"), name).back() - right);
    const double quarter = std::abs(column(run("exact", "0.5 ms"), name).back() - right);
    INFO(name << ": " << coarse << ", " << halved << ", " << quarter);
    CHECK(coarse / quarter > 14.0);  // 16 for order 2, 4 for order 1
    CHECK(halved / quarter > 3.5);
    CHECK(quarter < 5e-5 * column(fine, "damper.dissipated").back());
  }
}

TEST_CASE("The dissipated energy of a damper never falls") {
  const table::Table table = run_text(exercise("solver", "0.1 ms"));
  const auto& energy = column(table, "damper.dissipated");
  CHECK(energy.front() == 0.0);
  CHECK(energy.back() > 0.0);
  CHECK(std::is_sorted(energy.begin(), energy.end()));
}

TEST_CASE("Without changes of current no switching work is booked") {
  const table::Table table = run_text(R"(
step: 0.1 ms
stop: 0.5 s
solver: rk4
blocks:
  velocity: {block: Sine, amplitude: 0.1 m/s, frequency: 4 Hz}
  damper:   {block: MRDamper, velocity: velocity, current: 0.2 A, initial: 3 mm}
record: [damper.switching_work, damper.stored]
)");
  for (const double work : column(table, "damper.switching_work")) CHECK(std::abs(work) < 1e-9);
}

TEST_CASE("The exact step agrees with the solver and converges with the square of the step") {
  const auto end = [](const table::Table& table) { return column(table, "damper.z").back(); };
  const double fine = end(run_text(exercise("solver", "0.01 ms")));
  const double coarse = std::abs(end(run_text(exercise("exact", "1 ms"))) - fine);
  const double halved = std::abs(end(run_text(exercise("exact", "0.5 ms"))) - fine);
  CHECK(coarse < 1e-4);
  CHECK(halved < 0.35 * coarse);
}

TEST_CASE("The exact step is stable where an explicit solver blows up") {
  const std::string fast = R"(
step: 5 ms
stop: 1 s
solver: rk4
blocks:
  velocity: {block: Sine, amplitude: 0.5 m/s, frequency: 4 Hz}
  damper:   {block: MRDamper, velocity: velocity, current: 0.2 A, integration: exact}
record: [damper.z]
)";
  for (const double z : column(run_text(fast), "damper.z")) CHECK(std::abs(z) <= 10.2384e-3);
}

TEST_CASE("The stiffest damper that a fit may try stays within its limit at 300 mm/s and 1 kHz") {
  // beta + |gamma| = 200 per mm: an explicit solver would need steps of some 10 us.
  const auto [n, gamma] = GENERATE(Catch::Generators::table<double, double>(
      {{1.0, 90.0}, {1.0, -90.0}, {1.0, -100.0}, {1.5, 90.0}, {1.5, -90.0}, {2.0, 99.0}, {2.0, -99.0}}));
  CAPTURE(n, gamma);
  // For n other than 1 beta is a bare SI number; at the limit of z it acts as a rate of 200 per mm too.
  const double A = 10.0, limit = 0.05e-3;  // [m]
  const double rate = A / std::pow(limit, n), share = gamma / 200.0;
  const double beta = n == 1.0 ? 100e3 : rate * 0.5;
  const double gamma_si = n == 1.0 ? gamma * 1e3 : rate * share;
  const table::Table table = run_text(fmt::format(R"(
step: 1 ms
stop: 1 s
solver: rk4
blocks:
  velocity: {{block: Sine, amplitude: 300 mm/s, frequency: 4 Hz}}
  damper:   {{block: MRDamper, velocity: velocity, current: 0.2 A, A: {}, n: {}, beta: {}, gamma: {}, integration: exact}}
record: [damper.z, damper.dissipated]
)",
                                                  A, n, beta, gamma_si));
  const double least = beta - std::abs(gamma_si);  // of either direction; 0: a spring that never yields
  const double bound = least > 0.0 ? std::pow(A / least, 1.0 / n) : 1.0;
  double before = 0.0;
  for (const double z : column(table, "damper.z")) CHECK(std::abs(z) <= bound);
  for (const double heat : column(table, "damper.dissipated")) {
    CHECK(heat >= before);
    before = heat;
  }
}

TEST_CASE("A stiffness and an offset add to the damper's force") {
  const table::Table table = run_text(R"(
step: 1 ms
stop: 0.1 s
solver: rk4
blocks:
  damper: {block: MRDamper, velocity: 0 m/s, current: 0 A, position: 3 mm, k0: -1 N/mm, f0: 50 N}
record: [damper.force]
)");
  CHECK(column(table, "damper.force").back() == Approx(47.0));
}

TEST_CASE("Parameters in millimetres, newtons and seconds are those of the preset") {
  const std::string printed =
      ", A: 36.2095, beta: 10.6140 1/mm, gamma: -7.0773 1/mm, alpha: {value: [72.8, -42.88, 14.83, 0.29], "
      "unit: N/mm}, "
      "c: {value: [-9.37, 10.22, -4.33, 0.89, 0.02], unit: N s/mm}";
  CHECK(steady_force("10 mm/s", "0.3 A", printed) == Approx(steady_force("10 mm/s", "0.3 A")).epsilon(1e-14));
}

TEST_CASE("A damper given by the limit of z is the one of beta and gamma") {
  // 10.614 - 7.0773 = 3.5367 per mm: z settles at 36.2095/3.5367 mm; for n = 2 at the root
  // of 36.2095/3.5367e6 m^2.
  const table::Table table = run_text(R"(
step: 0.1 ms
stop: 1 s
solver: rk4
blocks:
  velocity: {block: Sine, amplitude: 100 mm/s, frequency: 3 Hz}
  one:  {block: MRDamper, velocity: velocity, current: 0.2 A}
  same: {block: MRDamper, velocity: velocity, current: 0.2 A, z_max: = 36.2095/3.5367*1 mm, ratio: = -7.0773/10.614}
  two:  {block: MRDamper, velocity: velocity, current: 0.2 A, beta: 10.614e6, gamma: -7.0773e6, n: 2, integration: exact}
  too:  {block: MRDamper, velocity: velocity, current: 0.2 A, z_max: = sqrt(36.2095/3.5367)*1 mm, ratio: = -7.0773/10.614, n: 2,
         integration: exact}
record: [one.force, same.force, two.force, too.force]
)");
  for (std::size_t k = 0; k < table.rows(); k += 10) {
    CHECK(column(table, "same.force")[k] == Approx(column(table, "one.force")[k]).margin(1e-9));
    CHECK(column(table, "too.force")[k] == Approx(column(table, "two.force")[k]).margin(1e-9));
  }
}

TEST_CASE("What is no damper is refused with the reason") {
  const auto error = [](const std::string& parameters) {
    return error_of(
        "step: 1 ms\nstop: 1 s\nsolver: rk4\nblocks:\n  damper: {block: MRDamper, velocity: 0 m/s, current: "
        "0 A, " +
        parameters + "}\n");
  };
  CHECK_THAT(error("A: 0"), Catch::Contains("damper.A"));
  CHECK_THAT(error("gamma: -11 1/mm"), Catch::Contains("damper.gamma") && Catch::Contains("above beta"));
  CHECK_THAT(error("z_max: 3 mm, ratio: -1"), Catch::Contains("damper.ratio"));
  CHECK_THAT(error("z_max: -1 mm"), Catch::Contains("damper.z_max"));
  CHECK(error("z_max: 3 mm, gamma: -11 1/mm").empty());  // z_max and ratio replace gamma
  CHECK_THAT(error("current_range: [0 A, 0.7 A]"), Catch::Contains("damper.c") && Catch::Contains("push"));
  CHECK_THAT(error("current_range: [0.3 A, 0.1 A]"), Catch::Contains("damper.current_range"));
  CHECK(error("n: 2, integration: exact").empty());
  CHECK_THAT(error("k0: 1 N/mm"), Catch::Contains("position") && Catch::Contains("k0 is not 0"));
  CHECK(error("extrapolate: raw, current_range: [0 A, 0.7 A]").empty());
}
