// Properties of the parts of the polar interface, beyond the claims of the figures that use them.
#include <catch2/catch.hpp>
#include <cmath>

#include "tests/support/run_text.hpp"

using namespace stepwire;

namespace {

double last(const table::Table& table, const std::string& name) {
  return column(table, name).back();
}

/// The controller without feedback, at an angle of 0.3 rad and a length of 0.2 m; forces as [x, y].
table::Table commanded(const std::string& wanted, const std::string& measured) {
  return run_text("step: 1 ms\nstop: 10 ms\nblocks:\n  wanted: {block: Rotate, u: " + wanted +
                  ", angle: 0.3}\n  measured: {block: Rotate, u: " + measured + R"(, angle: 0.3}
  control: {diagram: ../diagrams/parts/force-feedback-controller.yaml, wanted: wanted, measured: measured, length: 200 mm,
            angle: 0.3, kp: 0, ki: 0 Hz}
record: [control.linear, control.rotary, control.wanted, control.realisable, control.delivered]
)");
}

/// Friction of both dampers in steady motion, thesis eq. 4-10, in N and N m.
double friction_of_linear(double i) {
  return 36.2095 / (10.6140 - 7.0773) * (72.8 * i * i * i - 42.88 * i * i + 14.83 * i + 0.29);
}
double friction_of_rotary(double i) {
  return 2.7789 / (5.1269 + 1.5960) * 0.112984829 * (-25.99 * i * i * i + 49.02 * i * i + 28.05 * i + 5.23);
}

}  // namespace

TEST_CASE("The controller's currents make the wanted force at each joint by the dampers' friction") {
  const table::Table table = commanded("[-12 N, 6 N]", "[5 N, -3 N]");
  CHECK(friction_of_linear(last(table, "control.linear")) == Approx(12.0).epsilon(1e-4));
  CHECK(friction_of_rotary(last(table, "control.rotary")) == Approx(6.0 * 0.2).epsilon(1e-4));
  for (const std::string what : {"control.wanted", "control.realisable"}) {
    CHECK(last(table, what + ".1") == Approx(-12.0));
    CHECK(last(table, what + ".2") == Approx(6.0));
  }
  CHECK(last(table, "control.delivered.1") == Approx(-5.0));
  CHECK(last(table, "control.delivered.2") == Approx(3.0));
}

TEST_CASE(
    "What the dampers cannot make is not realisable: more than their friction at full current, or a push") {
  const table::Table much = commanded("[-50 N, 20 N]", "[5 N, -3 N]");
  CHECK(last(much, "control.linear") == Approx(0.35).epsilon(1e-3));
  CHECK(last(much, "control.rotary") == Approx(0.75).epsilon(1e-3));
  CHECK(last(much, "control.realisable.1") == Approx(-friction_of_linear(0.35)).epsilon(1e-4));
  CHECK(last(much, "control.realisable.2") == Approx(friction_of_rotary(0.75) / 0.2).epsilon(1e-4));
  const table::Table push = commanded("[-12 N, 6 N]", "[-5 N, -3 N]");  // the hand itself goes inward
  CHECK(last(push, "control.linear") == 0.0);
  CHECK(last(push, "control.realisable.1") == 0.0);
  CHECK(last(push, "control.rotary") > 0.1);
}

TEST_CASE("Where nothing is wanted no current flows") {
  const table::Table table = commanded("[0 N, 0 N]", "[5 N, -3 N]");
  CHECK(last(table, "control.linear") == 0.0);
  CHECK(last(table, "control.rotary") == 0.0);
}

TEST_CASE("The sensors of the polar interface find pin and force from what is measured at its joints") {
  const table::Table table = run_text(R"yaml(
step: 1 ms
stop: 3 s
blocks:
  pin:     {block: Pusher, points: [[205 mm, -20 mm], [243 mm, 15 mm]], speed: 20 mm/s}
  x_and_y: {block: Demux, u: pin.position, sizes: [1, 1]}
  length:  {block: Norm, u: pin.position}
  angle:   {block: Atan2, opposite: x_and_y.y2, adjacent: x_and_y.y1}
  joint:   {block: Rotate, u: [6 N, -4 N], angle: angle, inverse: true}
  sensors: {diagram: ../diagrams/parts/polar-sensors.yaml, length: length, angle: angle, joint_force: joint, noise: 0 mm, linearity: 0,
            force_noise: 0 N}
record: [pin.position, sensors.position, sensors.force]
)yaml");
  // Half a count of the encoder at up to 243.5 mm, and half a level of the potentiometer. The gauges are at
  // 0, 120 and 240 degrees, with 20 N/V each; half a level of each adds up.
  const double turn = M_PI / 4000.0, across = 0.2435 * turn, along = 0.150 / 16384.0 / 2.0;
  const double level = 20.0 / 16384.0, x = 20.0 * 2.0 / 3.0 * 2.0 * std::sin(M_PI / 3.0),
               y = 20.0 * 2.0 / 3.0 * 2.0;
  const double force = std::hypot(x, y) * level / 2.0 + std::hypot(6.0, 4.0) * turn;
  double worst = 0.0, worst_force = 0.0;
  for (std::size_t k = 0; k < column(table, "time").size(); ++k) {
    const auto off = [&](const std::string& a, const std::string& b) {
      return column(table, a)[k] - column(table, b)[k];
    };
    worst = std::max(worst, std::hypot(off("sensors.position.1", "pin.position.1"),
                                       off("sensors.position.2", "pin.position.2")));
    worst_force = std::max(worst_force, std::hypot(column(table, "sensors.force.1")[k] - 6.0,
                                                   column(table, "sensors.force.2")[k] + 4.0));
  }
  CHECK(worst <= std::hypot(across, along) * (1.0 + 1e-6));
  CHECK(worst > 0.8 * across);
  CHECK(worst_force <= force);
}

TEST_CASE(
    "A polar platform that is pulled about and switched out of time gives out no energy and loses none") {
  const table::Table table = run_text(R"(
step: 0.1 ms
stop: 3 s
solver: rk4
blocks:
  hand:     {block: Sine, amplitude: [9 N, 4 N], frequency: [0.7 Hz, 1.1 Hz]}
  linear:   {block: Pulse, amplitude: 0.35 A, period: 0.231 s, width: 0.4}
  rotary:   {block: Pulse, amplitude: 0.75 A, period: 0.347 s, width: 0.4}
  platform: {diagram: ../diagrams/parts/free-polar-platform.yaml, external: hand, linear: linear, rotary: rotary}
stop_when: abs(platform.length - 224 mm) > 25 mm
record: [platform.least_gain, platform.supplied, platform.damper_work, platform.kinetic_energy, platform.length, platform.angle]
)");
  CHECK(last(table, "platform.least_gain") > -1e-12);
  CHECK(column(table, "time").back() > 0.3);
  CHECK(last(table, "platform.supplied") ==
        Approx(last(table, "platform.damper_work") + last(table, "platform.kinetic_energy")).epsilon(1e-7));
}

TEST_CASE(
    "Pushed around the base at full current the rotary damper is felt with its torque over the length") {
  // rigs that are brake-like: 10.0, 8.9 and 8.0 N at 200, 224 and 250 mm, and 1.09 N off at 224 mm
  const auto felt = [](const std::string& radius, const std::string& current) {
    const table::Table table = run_text(
        "step: 0.25 ms\nstop: 2 s\nsolver: rk4\nblocks:\n  phase: {block: Ramp, slope: 0.05 rad/s}\n  arm: "
        "{block: Constant, value: [" +
        radius + R"(, 0 mm]}
  swing:    {block: Constant, value: [0 mm, )" +
        radius + R"(]}
  position: {block: Rotate, u: arm, angle: phase}
  tangent:  {block: Rotate, u: swing, angle: phase}
  velocity: {block: Gain, u: tangent, gain: 0.05 Hz}
  platform: {diagram: ../diagrams/parts/polar-platform.yaml, position: position, velocity: velocity, acceleration: [0, 0], linear: 0 A,
             rotary: )" +
        current + "}\nrecord: [platform.joint_force]\n");
    return last(table, "platform.joint_force.2");
  };
  CHECK(felt("200 mm", "0.75 A") == Approx(10.0).margin(0.05));
  CHECK(felt("224 mm", "0.75 A") == Approx(8.94).margin(0.05));
  CHECK(felt("250 mm", "0.75 A") == Approx(8.0).margin(0.05));
  CHECK(felt("224 mm", "0 A") == Approx(1.09).margin(0.02));
}

namespace {

/// Returns the commands of the polar interface for a force that needs both dampers; `pin` has the keys of the
/// part that moves it.
table::Table held(const std::string& pin) {
  return run_text(
      "step: 0.1 ms\nstop: 1.1 s\nsolver: rk4\nblocks:\n  held: {block: Step, time: 1 s, before: 1, after: "
      "0}\n" +
      ("  rig: {" + pin + ", wanted: [-12 N, -5 N], dead_man: held}\n") +
      "record: {every: 1 ms, signals: [rig.linear, rig.rotary, rig.cause]}\n");
}

}  // namespace

TEST_CASE("Letting go of the dead-man switch takes the current from both dampers within one sample") {
  for (const std::string pin :
       {"diagram: ../diagrams/parts/polar-rig.yaml, points: [[212 mm, -15 mm], [240 mm, 15 mm]]",
        "diagram: ../diagrams/parts/polar-interface.yaml, external: [10 N, 4 N]"}) {
    INFO(pin);
    const table::Table table = held(pin);
    const auto linear = column(table, "rig.linear"), rotary = column(table, "rig.rotary");
    CHECK(linear[990] > 0.05);
    CHECK(rotary[990] > 0.05);
    for (std::size_t tick = 1001; tick < linear.size(); ++tick) REQUIRE(linear[tick] + rotary[tick] == 0.0);
    CHECK(last(table, "rig.cause") == 0.0);
  }
}

TEST_CASE("The ramp of the polar rig brings the current in by parts of its time, and leaves it alone after") {
  const std::string pin =
      "diagram: ../diagrams/parts/polar-rig.yaml, instrumented: 0, tare_time: 0 s, "
      "points: [[212 mm, -15 mm], [240 mm, 15 mm]]";
  const auto at_once = column(held(pin), "rig.linear"),
             slowly = column(held(pin + ", ramp: 0.8 s"), "rig.linear");
  CHECK(at_once[40] > 0.05);
  CHECK(slowly[40] < at_once[40] * 0.2);
  const double most = 0.35;  // [A]
  for (std::size_t tick = 1; tick < 800; ++tick)
    REQUIRE(slowly[tick] <= most * static_cast<double>(tick + 1) / 800.0);
  CHECK(slowly[990] == Approx(at_once[990]).epsilon(0.02));
}

namespace {

/// Measured force under a load of [6, -4] N from 0.1 s on, with gauges that show something without any.
table::Table tared(const std::string& time) {
  return run_text(R"(
step: 1 ms
stop: 0.3 s
blocks:
  load:    {block: Step, time: 0.1 s, before: [0 N, 0 N], after: [6 N, -4 N]}
  sensors: {diagram: ../diagrams/parts/polar-sensors.yaml, length: 224 mm, angle: 0 rad, joint_force: load,
            gauge_offset: [0.3 V, -0.2 V, 0.1 V, -0.4 V, 0.2 V, 0.5 V], force_noise: 0 N, tare_time: )" +
                  time + "}\nrecord: [sensors.joint_force]\n");
}

}  // namespace

TEST_CASE("A tare before the run takes out of the measured force what the gauges show without a load") {
  // gauges at 0, 120 and 240 degrees, a level of the board of 1.22 mV
  const double level = 20.0 * 20.0 / 16384.0;
  for (const std::string& time : {"1 ms", "50 ms"}) {
    const table::Table table = tared(time);
    CHECK(std::abs(column(table, "sensors.joint_force.1")[90]) < 1e-9);
    CHECK(last(table, "sensors.joint_force.1") == Approx(6.0).margin(level * 2.0));
    CHECK(last(table, "sensors.joint_force.2") == Approx(-4.0).margin(level * 2.0));
  }
  const table::Table without = tared("0 s");
  CHECK(std::hypot(last(without, "sensors.joint_force.1") - 6.0,
                   last(without, "sensors.joint_force.2") + 4.0) > 1.0);
}
