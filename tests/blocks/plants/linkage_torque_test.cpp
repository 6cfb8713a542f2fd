// A link that is turned about its anchor: the polar interface.
#include <catch2/catch.hpp>
#include <cmath>

#include "tests/support/run_text.hpp"

using namespace stepwire;

namespace {

constexpr double pin = 0.8, rod = 0.15, centre = 0.065, rod_inertia = 2.1e-4, housing = 2.7e-3;
const std::string bodies =
    "anchors: [[0.02, -0.01]], pin_mass: 0.8 kg, rod_mass: 0.15 kg, rod_centre: 65 mm, rod_inertia: 2.1e-4 "
    "kg "
    "m2, housing_inertia: 2.7e-3 kg m2";

/// In polar coordinates about the anchor, from their definition.
struct Polar {
  double r, turn, radial_speed;  ///< turn: angular velocity

  Polar(const table::Table& table, std::size_t k) {
    const auto at = [&](const std::string& name) { return column(table, "rig." + name)[k]; };
    const double x = at("position.1") - 0.02, y = at("position.2") + 0.01, u = at("velocity.1"),
                 v = at("velocity.2");
    r = std::hypot(x, y);
    turn = (x * v - y * u) / (r * r);
    radial_speed = (x * u + y * v) / r;
  }
  double inertia() const { return pin * r * r + rod_inertia + housing + rod * (r - centre) * (r - centre); }
  double angular_momentum() const { return inertia() * turn; }
  double energy() const {
    return 0.5 * inertia() * turn * turn + 0.5 * (pin + rod) * radial_speed * radial_speed;
  }
};

table::Table thrown(const std::string& torque, const std::string& force) {
  return run_text("step: 0.1 ms\nstop: 0.4 s\nsolver: rk4\nblocks:\n  torque: " + torque + "\n  force: " +
                  force + "\n  rig: {block: Linkage, force: force, torque: torque, " + bodies +
                  R"(, initial_position: [0.24, 0], initial_velocity: [-0.1, 0.3]}
  impulse: {block: Integrator, u: torque}
  along:   {block: Product, u: [force, rig.rate]}
  around:  {block: Product, u: [torque, rig.angular_rate]}
  power:   {block: Sum, u: [along, around]}
  work:    {block: Integrator, u: power}
record: [rig.position, rig.velocity, rig.kinetic_energy, rig.angular_rate, rig.rate, impulse, work]
)");
}

const std::string no_torque = "{block: Constant, value: 0 N m}", no_force = "{block: Constant, value: 0 N}";

}  // namespace

TEST_CASE("A polar platform that is left alone keeps its angular momentum and its energy") {
  const table::Table table = thrown(no_torque, no_force);
  const Polar first(table, 0);
  for (std::size_t k = 0; k < column(table, "time").size(); k += 100) {
    const Polar now(table, k);
    CHECK(now.angular_momentum() == Approx(first.angular_momentum()).epsilon(1e-10));
    CHECK(now.energy() == Approx(first.energy()).epsilon(1e-10));
    CHECK(column(table, "rig.kinetic_energy")[k] == Approx(now.energy()).epsilon(1e-12));
    CHECK(column(table, "rig.angular_rate")[k] == Approx(now.turn).epsilon(1e-12));
  }
}

TEST_CASE(
    "A torque adds its impulse to the angular momentum, whatever the radial force, and both their work to "
    "the energy") {
  const table::Table table = thrown("{block: Sine, amplitude: 0.5 N m, frequency: 3 Hz, phase: 1}",
                                    "{block: Sine, amplitude: 4 N, frequency: 5 Hz, bias: -2 N}");
  const Polar first(table, 0);
  for (std::size_t k = 0; k < column(table, "time").size(); k += 100) {
    const Polar now(table, k);
    CHECK(now.angular_momentum() - first.angular_momentum() ==
          Approx(column(table, "impulse")[k]).margin(1e-11));
    CHECK(now.energy() - first.energy() == Approx(column(table, "work")[k]).margin(1e-11));
  }
}

TEST_CASE("Along a circle the pusher feels the torque over the arm and the centrifugal force, and no more") {
  // r = 0.2 m, turning at 3 rad/s: pin and rod pull outward by their mass times radius times 9.
  const table::Table table = run_text("step: 1 ms\nstop: 1 s\nsolver: rk4\nblocks:\n" + std::string(R"(
  phase:    {block: Ramp, slope: 3 rad/s}
  cosine:   {block: Trig, function: cos, u: phase}
  sine:     {block: Trig, function: sin, u: phase}
  spoke:    {block: Mux, u: [cosine, sine]}
  tangent:  {block: Rotate, u: spoke, angle: 90 deg}
  arm:      {block: Gain, u: spoke, gain: 0.2 m}
  position: {block: Sum, u: [arm, [0.02 m, -0.01 m]]}
  velocity: {block: Gain, u: tangent, gain: 0.6 m/s}
  acceleration: {block: Gain, u: spoke, gain: -1.8 m/s2}
  rig: {block: DrivenLinkage, position: position, velocity: velocity, acceleration: acceleration, force: 0 N,
        torque: -0.3 N m, )") + bodies +
                                      R"(}
  felt: {block: Rotate, u: rig.external, angle: phase, inverse: true}
record: [felt, rig.angular_rate]
)");
  const double centrifugal = (pin * 0.2 + rod * (0.2 - centre)) * 9.0;
  for (std::size_t k = 0; k < column(table, "time").size(); k += 50) {
    CHECK(column(table, "felt.1")[k] == Approx(-centrifugal).epsilon(1e-9));
    CHECK(column(table, "felt.2")[k] == Approx(0.3 / 0.2).epsilon(1e-9));
    CHECK(column(table, "rig.angular_rate")[k] == Approx(3.0).epsilon(1e-9));
  }
}

TEST_CASE("A torque on a link that is not in the plane is refused") {
  CHECK_THAT(
      error_of(
          "step: 1 ms\nstop: 1 s\nsolver: rk4\nblocks:\n  rig: {block: Linkage, force: 0 N, torque: 1 N m, "
          "pin_mass: 1 kg, anchors: [[0, 0, 0]], initial_position: [1, 0, 0]}\n"),
      Catch::Contains("rig.anchors") && Catch::Contains("in the plane only"));
}
