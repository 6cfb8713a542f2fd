#include <catch2/catch.hpp>
#include <cmath>

#include "tests/support/run_text.hpp"

using namespace stepwire;

namespace {

/// The output of a block where its input goes from -10 to 10 in steps of 0.25.
std::vector<double> curve(const std::string& keys, std::vector<double>& u) {
  const table::Table table =
      run_text("step: 0.25\nstop: 20\nblocks:\n  u: {block: Ramp, slope: 1, initial: -10}\n  y: {" + keys +
               ", u: u}\nrecord: [u, y]\n");
  u = column(table, "u");
  return column(table, "y");
}

template <class Law>
void check_law(const std::string& keys, Law law) {
  std::vector<double> u;
  const auto y = curve(keys, u);
  REQUIRE(u.size() == 81);
  for (std::size_t k = 0; k < u.size(); ++k) {
    INFO(keys << " at " << u[k]);
    CHECK(y[k] == Approx(law(u[k])).margin(1e-12));
  }
}

}  // namespace

TEST_CASE("A saturation keeps its input within its limits") {
  check_law("block: Saturation, lower: -4, upper: 5",
            [](double u) { return std::min(std::max(u, -4.0), 5.0); });
  check_law("block: Saturation, upper: 5", [](double u) { return std::min(u, 5.0); });
  check_law("block: Saturation", [](double u) { return u; });
}

TEST_CASE("A dead zone gives what lies outside of it") {
  check_law("block: DeadZone, lower: -4, upper: 5", [](double u) {
    return u > 5 ? u - 5 : u < -4 ? u + 4 : 0.0;
  });
}

TEST_CASE("Limits may differ from element to element") {
  const table::Table table = run_text(R"(
step: 1
stop: 1
blocks:
  u: {block: Constant, value: [7, -7, 7]}
  y: {block: Saturation, lower: [-1, -2, -3], upper: 4, u: u}
record: [y]
)");
  CHECK(column(table, "y.1")[0] == 4.0);
  CHECK(column(table, "y.2")[0] == -2.0);
  CHECK(column(table, "y.3")[0] == 4.0);
}

TEST_CASE("Crossed limits are refused") {
  const std::string head = "step: 1\nstop: 1\nblocks:\n";
  CHECK_THAT(error_of(head + "  s: {block: Saturation, lower: 2, upper: 1, u: 1}\n"),
             Catch::Contains("s.lower"));
  CHECK_THAT(error_of(head + "  s: {block: DeadZone, lower: 2, upper: 1, u: 1}\n"),
             Catch::Contains("s.lower"));
  CHECK_THAT(error_of(head + "  r: {block: Relay, switch_off: 2, switch_on: 1, u: 1}\n"),
             Catch::Contains("r.switch_off"));
}

TEST_CASE("A quantizer rounds to the nearest level and goes up halfway") {
  check_law("block: Quantizer, interval: 0.5", [](double u) { return std::floor(u * 2.0 + 0.5) / 2.0; });
  std::vector<double> u;
  const auto y = curve("block: Quantizer, interval: 1", u);
  CHECK(y[static_cast<std::size_t>((0.5 + 10.0) * 4.0)] == 1.0);
  CHECK(y[static_cast<std::size_t>((-0.5 + 10.0) * 4.0)] == 0.0);
  CHECK(y[static_cast<std::size_t>((-1.5 + 10.0) * 4.0)] == -1.0);
}

TEST_CASE("The error of a quantizer has the power of uniform noise") {
  const table::Table table = run_text(R"(
step: 1 ms
stop: 10 s
blocks:
  u: {block: Ramp, slope: 0.7310585}
  q: {block: Quantizer, interval: 0.02, u: u}
record: [u, q]
)");
  double power = 0.0;
  for (std::size_t k = 0; k < table.rows(); ++k)
    power += std::pow(column(table, "q")[k] - column(table, "u")[k], 2.0) / static_cast<double>(table.rows());
  CHECK(std::sqrt(power) == Approx(0.02 / std::sqrt(12.0)).epsilon(5e-3));
}

TEST_CASE("Coulomb friction has the sign of the speed and none at rest") {
  check_law("block: Coulomb, coulomb: 3, viscous: 0.5", [](double v) {
    return (v > 0 ? 3.0 : v < 0 ? -3.0 : 0.0) + 0.5 * v;
  });
  check_law("block: Coulomb, coulomb: 3, viscous: 0.5, smoothing: 2",
            [](double v) { return 3.0 * std::tanh(v / 2.0) + 0.5 * v; });
}

TEST_CASE("Friction takes the energy of its closed form from a sine") {
  // Over a period of v = a sin(w t): dry friction takes 4 a c / w, viscous friction pi a^2 d / w.
  const table::Table table = run_text(R"(
step: 0.1 ms
stop: 1 s
solver: rk4
blocks:
  v: {block: Sine, amplitude: 0.3 m/s, frequency: 1}
  f: {block: Coulomb, coulomb: 5 N, viscous: 2 N s/m, u: v}
  power: {block: Product, u: [v, f]}
  energy: {block: Integrator, u: power}
record: [f, energy]
)");
  const double pi = std::acos(-1.0), w = 2.0 * pi;
  CHECK(column(table, "energy").back() == Approx((4.0 * 0.3 * 5.0 + pi * 0.09 * 2.0) / w).epsilon(1e-6));
  CHECK(table.find("f")->unit == "N");
  CHECK(table.find("energy")->unit == "N m");
}
