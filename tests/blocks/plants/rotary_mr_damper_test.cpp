#include <catch2/catch.hpp>
#include <cmath>

#include "tests/support/run_text.hpp"

using namespace stepwire;

namespace {

constexpr double lbf_in = 0.1129848290276167;  // 4.4482216152605 N times 0.0254 m, both exact by definition

/// Torque while turning at 1 rad/s, after this many seconds.
double torque(const std::string& current, const std::string& time = "10 s", const std::string& more = "") {
  const table::Table table =
      run_text("step: 1 ms\nstop: " + time +
               "\nsolver: rk4\nblocks:\n  brake: {block: RotaryMRDamper, preset: rd-2087-01, "
               "velocity: 1 rad/s, current: " +
               current + more + "}\nrecord: [brake.torque]\n");
  return column(table, "brake.torque").back();
}

double z_limit() {
  return 2.7789 / (5.1269 + 1.5960);
}

}  // namespace

TEST_CASE("The rotary damper reaches the torques that follow from the published numbers") {
  const double alpha = -25.99 * 0.421875 + 49.02 * 0.5625 + 28.05 * 0.75 + 5.23;
  const double c = -0.208 * 0.421875 + 0.377 * 0.5625 - 0.215 * 0.75 + 0.042;
  CHECK(alpha * z_limit() == Approx(17.7).epsilon(0.01));
  CHECK(torque("0.75 A") == Approx((alpha * z_limit() + c) * lbf_in).epsilon(1e-6));
  CHECK(torque("0.75 A") == Approx(2.0).epsilon(0.01));  // N m: the size of the transducer used
  CHECK(torque("0 A") == Approx(0.24).epsilon(0.05));
}

TEST_CASE("Another torque unit scales the rotary damper") {
  CHECK(torque("0.75 A", "10 s", ", torque_unit: N m") == Approx(torque("0.75 A") / lbf_in));
  CHECK(torque("0.75 A", "10 s", ", torque_unit: lbf.ft") == Approx(torque("0.75 A") * 12.0));
  CHECK(torque("0.75 A", "10 s", ", torque_unit: N cm") == Approx(torque("0.75 A") / lbf_in / 100.0));
}

TEST_CASE("A pre-sliding scale shortens the angle over which the torque builds up and keeps its limit") {
  CHECK(torque("0.75 A", "10 s", ", presliding_scale: 20") == Approx(torque("0.75 A")).epsilon(1e-6));
  // At 1 rad/s one second is one radian.
  CHECK(torque("0.75 A", "0.05 s", ", presliding_scale: 2") ==
        Approx(torque("0.75 A", "0.1 s")).epsilon(1e-6));
}

TEST_CASE("Above its identified range the rotary damper keeps its torque") {
  CHECK(torque("1.5 A") == torque("0.75 A"));
}

TEST_CASE("Scaled pre-sliding stores the energy that a slip of one z limit allows") {
  const table::Table table = run_text(R"(
step: 1 ms
stop: 5 s
solver: rk4
blocks:
  brake: {block: RotaryMRDamper, velocity: 1 rad/s, current: 0.75 A, presliding_scale: 20}
record: [brake.stored]
)");
  const double alpha = (-25.99 * 0.421875 + 49.02 * 0.5625 + 28.05 * 0.75 + 5.23) * lbf_in;
  CHECK(column(table, "brake.stored").back() ==
        Approx(alpha * z_limit() * z_limit() / (2.0 * 2.7789 * 20.0)));
  CHECK(column(table, "brake.stored").back() == Approx(7.5e-3).epsilon(0.02));
}
