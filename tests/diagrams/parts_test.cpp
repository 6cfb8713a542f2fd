// Properties of the parts of rigs, beyond the claims of the figures that use them.
#include <catch2/catch.hpp>
#include <cmath>

#include "tests/support/run_text.hpp"

using namespace stepwire;

namespace {

double largest_difference(const table::Table& table, const std::string& a, const std::string& b) {
  double worst = 0.0;
  for (std::size_t k = 0; k < column(table, a).size(); ++k)
    worst = std::max(worst, std::abs(column(table, a)[k] - column(table, b)[k]));
  return worst;
}

}  // namespace

TEST_CASE("The sensors of the planar rig find the pin from the lengths of both dampers") {
  // A reading is off by half a level of its converter, 150 mm / 2^14 / 2; at 45 degrees two of them add up to
  // sqrt(2) of one.
  const table::Table table = run_text(R"yaml(
step: 1 ms
stop: 3 s
blocks:
  pin:      {block: StraightMotion, from: [-15 mm, 185 mm], direction: [1, 1], speed: 14 mm/s}
  x_and_y:  {block: Demux, u: pin.position, sizes: [1, 1]}
  left:     {block: Expression, u: [x_and_y.y1, x_and_y.y2], expression: "hypot(u1 + 158.4 mm, u2 - 358.4 mm)"}
  right:    {block: Expression, u: [x_and_y.y1, x_and_y.y2], expression: "hypot(u1 - 158.4 mm, u2 - 358.4 mm)"}
  length:   {block: Mux, u: [left, right]}
  measured: {diagram: ../diagrams/parts/planar-rig-sensors.yaml, length: length, noise: 0 mm, linearity: 0}
units: {left: m, right: m}
record: [pin.position, measured.position]
)yaml");
  const double half_level = 0.150 / 16384.0 / 2.0;
  CHECK(largest_difference(table, "pin.position.1", "measured.position.1") < 1.6 * half_level);
  CHECK(largest_difference(table, "pin.position.2", "measured.position.2") < 1.6 * half_level);
  CHECK(largest_difference(table, "pin.position.1", "measured.position.1") > 0.5 * half_level);
}

TEST_CASE("A blocked motor pushes with its limit, and lets go as soon as it is faster than it should be") {
  const table::Table table = run_text(R"(
step: 1 ms
stop: 4 s
solver: rk4
blocks:
  rate:  {block: Step, time: 3 s, after: 30 mm/s}
  motor: {diagram: ../diagrams/parts/linear-motor.yaml, rate: rate, speed: 10 mm/s, limit: 50 N}
record: [motor.force]
)");
  const auto& force = column(table, "motor.force");
  CHECK(force[2999] == 50.0);                              // 200 N/mm x 30 mm would be 6000 N
  CHECK(force[3000] == Approx(50.0 - 60.0).margin(20.1));  // kp x 20 mm/s less, at once
  CHECK(force.back() == -50.0);
}

TEST_CASE("A damper that is shaken and switched out of time gives out no energy in any step") {
  const table::Table table = run_text(R"(
step: 0.1 ms
stop: 2 s
solver: rk4
blocks:
  rate:    {block: Sine, amplitude: 100 mm/s, frequency: 7 Hz}
  current: {block: Pulse, amplitude: 0.5 A, period: 0.0613 s, width: 0.4}
  damper:  {diagram: ../diagrams/parts/lagged-damper.yaml, rate: rate, current: current}
record: [damper.least_gain, damper.current, damper.work, damper.dissipated, damper.stored, damper.switching_work]
)");
  CHECK(column(table, "damper.least_gain").back() > -1e-12);
  for (const double current : column(table, "damper.current")) REQUIRE(current <= 0.35);
  const auto last = [&](const std::string& name) { return column(table, "damper." + name).back(); };
  CHECK(last("work") == Approx(last("dissipated") + last("stored") - last("switching_work")).epsilon(1e-7));
}

TEST_CASE(
    "The off-state of a damper is a share of the friction that it has without current, with any current") {
  const table::Table table = run_text(R"(
step: 0.1 ms
stop: 2 s
solver: rk4
blocks:
  rate:    {block: Constant, value: 10 mm/s}
  turning: {block: Constant, value: 10 rad/s}
  current: {block: Step, time: 1 s, after: 0.2 A}
  once:    {diagram: ../diagrams/parts/lagged-damper.yaml, rate: rate, current: current}
  thrice:  {diagram: ../diagrams/parts/lagged-damper.yaml, rate: rate, current: current, off_state: 3}
  slow:    {diagram: ../diagrams/parts/lagged-rotary-damper.yaml, rate: turning, current: current}
  tight:   {diagram: ../diagrams/parts/lagged-rotary-damper.yaml, rate: turning, current: current, off_state: 3}
record: [once.resistance, thrice.resistance, slow.resistance, tight.resistance]
)");
  // alpha(0) A/(beta + gamma), equations 4 to 6 and 8 to 10 of the thesis
  const double force = 0.29 * 36.2095 / (10.6140 - 7.0773);
  const double torque = 5.23 * 2.7789 / (5.1269 + 1.5960) * 4.4482216152605 * 0.0254;
  for (const std::size_t row : {9999u, 19999u}) {
    CHECK(column(table, "thrice.resistance")[row] - column(table, "once.resistance")[row] ==
          Approx(2.0 * force).epsilon(1e-6));
    CHECK(column(table, "tight.resistance")[row] - column(table, "slow.resistance")[row] ==
          Approx(2.0 * torque).epsilon(1e-6));
  }
}

TEST_CASE("A damper that is taken out neither moves nor resists") {
  const table::Table table = run_text(R"(
step: 1 ms
stop: 0.5 s
solver: rk4
blocks:
  damper: {diagram: ../diagrams/parts/lagged-damper.yaml, rate: 50 mm/s, current: 0.3 A, fitted: 0}
record: [damper.force, damper.dissipated]
)");
  for (const double force : column(table, "damper.force")) REQUIRE(force == 0.0);
  CHECK(column(table, "damper.dissipated").back() == 0.0);
}

TEST_CASE(
    "A platform that is pushed along one damper meets that damper alone, on a line, in the plane, in space") {
  // Away from the left anchor at 45 degrees. The other dampers turn, by so little that they stay in their
  // pre-sliding: 0.1 mm along them would be 1 N.
  const table::Table table = run_text(R"(
step: 0.25 ms
stop: 0.4 s
solver: rk4
blocks:
  line:  {diagram: ../diagrams/parts/lagged-damper.yaml, rate: 10 mm/s, current: 0.35 A}
  plane: {diagram: ../diagrams/parts/platform-2d.yaml, left: 0.35 A, right: 0 A, direction: -45 deg}
  space: {diagram: ../diagrams/parts/platform-3d.yaml, left: 0.35 A, right: 0 A, third: 0 A, azimuth: -45 deg}
record: [line.resistance, plane.external, space.external]
)");
  const double along = std::sqrt(0.5), line = column(table, "line.resistance").back();
  const auto last = [&](const std::string& name) { return column(table, name).back(); };
  CHECK(along * (last("plane.external.1") - last("plane.external.2")) == Approx(line).epsilon(0.01));
  CHECK(along * (last("space.external.1") - last("space.external.2")) == Approx(line).epsilon(0.01));
  CHECK(std::abs(last("plane.external.1") + last("plane.external.2")) < 1.0);
}
