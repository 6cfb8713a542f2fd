#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "tests/support/run_text.hpp"

using namespace stepwire;

namespace {

const std::string head = "step: 0.1 ms\nstop: 0.5 s\nsolver: rk4\nblocks:\n";

/// Link bodies that weigh and turn, all different from each other.
const std::string bodies =
    "pin_mass: 0.8 kg, rod_mass: [0.2, 0.3, 0.5], rod_inertia: [2e-4, 3e-4, 5e-4], rod_centre: [60 mm, 50 "
    "mm, "
    "80 mm], housing_inertia: [1e-3, 2e-3, 3e-3]";

const std::string planar = "anchors: [[-0.16, 0.36], [0.16, 0.36], [0, 0]]";
const std::string spatial = "anchors: [[-0.16, 0.36, 0.02], [0.16, 0.36, -0.03], [0, 0.2, 0.22]]";

/// Three links under forces that follow no rule, with the work of all forces beside them.
std::string exercise(const std::string& anchors, const std::string& start, const std::string& external) {
  return head + R"(
  f1:     {block: Sine, amplitude: 3 N, frequency: 3 Hz}
  f2:     {block: Sine, amplitude: 2 N, frequency: 5 Hz, phase: 1}
  f3:     {block: Sine, amplitude: 4 N, frequency: 2 Hz, phase: 2}
  force:  {block: Mux, u: [f1, f2, f3]}
  rig:    {block: Linkage, force: force, external: )" +
         external + ", " + anchors + ", " + bodies + ", " + start + R"(}
  links:  {block: Dot, u: [force, rig.rate]}
  hand:   {block: Dot, u: [)" +
         external + R"(, rig.velocity]}
  power:  {block: Sum, u: [links, hand]}
  work:   {block: Integrator, u: power}
  travel: {block: Integrator, u: rig.rate}
record: [rig.position, rig.velocity, rig.length, rig.kinetic_energy, work, travel]
)";
}

const std::string planar_start = "initial_position: [0.01, 0.2], initial_velocity: [0.05, -0.1]";
const std::string spatial_start = "initial_position: [0.01, 0.2, 0], initial_velocity: [0.05, -0.1, 0.02]";

/// Largest difference of work and gain of kinetic energy, relative to the latter's range.
double imbalance(const table::Table& table) {
  const auto &energy = column(table, "rig.kinetic_energy"), &work = column(table, "work");
  double worst = 0.0, most = 0.0;
  for (std::size_t k = 0; k < work.size(); ++k) {
    worst = std::max(worst, std::abs(energy[k] - energy[0] - work[k]));
    most = std::max(most, energy[k]);
  }
  return worst / most;
}

}  // namespace

TEST_CASE("The work of all forces on a linkage is its kinetic energy, in the plane and in space") {
  CHECK(imbalance(run_text(exercise(planar, planar_start, "[0.5, -0.3]"))) < 1e-9);
  CHECK(imbalance(run_text(exercise(spatial, spatial_start, "[0.5, -0.3, 0.2]"))) < 1e-9);
}

TEST_CASE("The links of a linkage end at its pin, and their rates are the rates of their lengths") {
  const table::Table table = run_text(exercise(planar, planar_start, "[0.5, -0.3]"));
  const double anchors[3][2] = {{-0.16, 0.36}, {0.16, 0.36}, {0.0, 0.0}};
  for (int link = 0; link < 3; ++link) {
    const std::string number = "." + std::to_string(link + 1);
    const auto &x = column(table, "rig.position.1"), &y = column(table, "rig.position.2");
    const auto &length = column(table, "rig.length" + number), &travel = column(table, "travel" + number);
    double open = 0.0, drift = 0.0;
    for (std::size_t k = 0; k < x.size(); ++k) {
      open =
          std::max(open, std::abs(std::hypot(x[k] - anchors[link][0], y[k] - anchors[link][1]) - length[k]));
      drift = std::max(drift, std::abs(length[k] - length[0] - travel[k]));
    }
    CHECK(open < 1e-15);
    CHECK(drift < 1e-11);
  }
}

TEST_CASE("A pin on links without mass flies straight on") {
  const table::Table table =
      run_text(head + "  rig: {block: Linkage, force: [0 N, 0 N, 0 N], pin_mass: 0.8 kg, " + spatial + ", " +
               spatial_start + "}\nrecord: [rig.position, rig.velocity]\n");
  const double end[] = {0.01 + 0.05 * 0.5, 0.2 - 0.1 * 0.5, 0.02 * 0.5};
  for (int i = 0; i < 3; ++i)
    CHECK(column(table, "rig.position." + std::to_string(i + 1)).back() == Approx(end[i]).margin(1e-14));
}

TEST_CASE("A link alone, whatever its force, keeps its angular momentum about its anchor") {
  const table::Table table = run_text(head + R"(
  force: {block: Sine, amplitude: 5 N, frequency: 4 Hz, bias: -1 N}
  rig:   {block: Linkage, force: force, anchors: [[0.1, 0, -0.2]], pin_mass: 0.3 kg, rod_mass: 0.5 kg,
          rod_inertia: 4e-4, rod_centre: 70 mm, housing_inertia: 2e-3, initial_position: [0.1, 0.3, 0.1],
          initial_velocity: [0.6, -0.2, 0.3]}
record: [rig.position, rig.velocity, rig.length]
)");
  const auto moment = [&](std::size_t k) {
    const auto at = [&](const std::string& name) { return column(table, "rig." + name)[k]; };
    const double x = at("position.1") - 0.1, y = at("position.2"), z = at("position.3") + 0.2;
    const double u = at("velocity.1"), v = at("velocity.2"), w = at("velocity.3"), l = at("length");
    const double inertia = 0.3 * l * l + 4e-4 + 2e-3 + 0.5 * (l - 0.07) * (l - 0.07);
    const double turn[] = {y * w - z * v, z * u - x * w, x * v - y * u};
    return std::array{inertia * turn[0] / (l * l), inertia * turn[1] / (l * l), inertia * turn[2] / (l * l)};
  };
  const auto first = moment(0), last = moment(column(table, "time").size() - 1);
  for (std::size_t i = 0; i < 3; ++i) CHECK(last[i] == Approx(first[i]).epsilon(1e-10));
}

TEST_CASE("A rod that spins at constant length pulls with the centrifugal force of its masses") {
  // With omega = 8 rad/s at 0.25 m: 0.3 kg at 0.25 m and 0.5 kg at 0.18 m.
  const double pull = (0.3 * 0.25 + 0.5 * 0.18) * 64.0;
  const table::Table table =
      run_text(head + "  rig: {block: Linkage, force: " + std::to_string(-pull) + R"( N,
    anchors: [[0, 0]], pin_mass: 0.3 kg, rod_mass: 0.5 kg, rod_inertia: 4e-4, rod_centre: 70 mm,
    housing_inertia: 2e-3, initial_position: [0.25, 0], initial_velocity: [0, 2]}
record: [rig.position, rig.length]
)");
  const auto& time = column(table, "time");
  for (std::size_t k = 0; k < time.size(); k += 50) {
    CHECK(column(table, "rig.length")[k] == Approx(0.25).epsilon(1e-9));
    CHECK(column(table, "rig.position.1")[k] == Approx(0.25 * std::cos(8.0 * time[k])).margin(1e-9));
  }
}

TEST_CASE("A link held at its length swings as a physical pendulum") {
  // 10 N pull the pin downward; the spring holds 0.25 m but for the 10 um that they stretch it.
  const table::Table table = run_text(head + R"(
  stretch: {block: Sum, signs: "+-", u: [rig.length, 0.24999 m]}
  spring:  {block: Gain, u: stretch, gain: -1e6 N/m}
  rig:     {block: Linkage, force: spring, external: [0 N, -10 N], anchors: [[0, 0]], pin_mass: 0.3 kg,
            rod_mass: 0.5 kg, rod_inertia: 4e-4, rod_centre: 70 mm, housing_inertia: 2e-3,
            initial_position: [0.1 mm, -250 mm]}
record: [rig.position]
)");
  const double inertia = 0.3 * 0.25 * 0.25 + 4e-4 + 2e-3 + 0.5 * 0.18 * 0.18;
  const double omega = std::sqrt(10.0 * 0.25 / inertia);
  const auto& time = column(table, "time");
  for (std::size_t k = 0; k < time.size(); k += 50)
    CHECK(column(table, "rig.position.1")[k] == Approx(1e-4 * std::cos(omega * time[k])).margin(1e-8));
}

TEST_CASE("A linkage and its mirror image move as mirror images") {
  const auto run = [](const std::string& sides, const std::string& start) {
    return run_text(
        head + "  rig: {block: Linkage, anchors: " + sides +
        ", pin_mass: 0.8 kg, rod_mass: [0.2, 0.2, 0.4], rod_centre: 50 mm, housing_inertia: 1e-3, " + start +
        "}\nrecord: [rig.position]\n");
  };
  const table::Table left = run("[[-0.16, 0.36], [0.16, 0.36], [0, 0]], force: [2 N, 0 N, 1 N]",
                                "initial_position: [0.01, 0.2], initial_velocity: [0.02, 0.1]");
  const table::Table right = run("[[0.16, 0.36], [-0.16, 0.36], [0, 0]], force: [2 N, 0 N, 1 N]",
                                 "initial_position: [-0.01, 0.2], initial_velocity: [-0.02, 0.1]");
  const auto &x = column(left, "rig.position.1"), &mirrored = column(right, "rig.position.1");
  for (std::size_t k = 0; k < x.size(); k += 50) CHECK(x[k] == -mirrored[k]);
  CHECK(column(left, "rig.position.2") == column(right, "rig.position.2"));
}

TEST_CASE("On a line a linkage is a mass") {
  const table::Table table = run_text(head + R"(
  force: {block: Sine, amplitude: 3 N, frequency: 3 Hz}
  rig:   {block: Linkage, force: force, external: 1 N, anchors: [[-0.2]], pin_mass: 0.5 kg, rod_mass: 0.25 kg,
          housing_inertia: 1e-3, rod_centre: 50 mm, initial_velocity: 0.1}
  sum:   {block: Sum, u: [force, 1 N]}
  mass:  {block: Mass, force: sum, mass: 0.75 kg, initial_velocity: 0.1}
record: [rig.position, mass.position]
)");
  CHECK(column(table, "rig.position") == column(table, "mass.position"));
}

TEST_CASE("A link beyond its stroke ends the run and is named with length and limit") {
  const auto message = [](const std::string& start) {
    return error_of(head + "  rig: {block: Linkage, force: [0 N, 0 N, 0 N], pin_mass: 1 kg, " + planar +
                    ", shortest: [195 mm, 195 mm, 0 mm], longest: [253 mm, 253 mm, 1 m], " + start + "}\n");
  };
  CHECK(message("initial_position: [0, 0.2]").empty());
  // The left link reaches 253 mm where (x + 160)^2 + 160^2 = 253^2, at x = 35.98 mm.
  CHECK_THAT(message("initial_position: [0, 0.2], initial_velocity: [0.1, 0]"),
             Catch::Contains("rig: a link leaves its stroke: link 1 is 0.253") &&
                 Catch::Contains(" m long, and 0.253 m is its longest (at 0.3599 s); the run ends here"));
  CHECK_THAT(message("initial_position: [0.04, 0.23]"),
             Catch::Contains("link 2 is 0.176918 m long, and 0.195 m is its shortest (at 0 s)"));
}

TEST_CASE("A pin on its anchor is told as such") {
  CHECK_THAT(error_of(head + "  rig: {block: Linkage, force: 0 N, pin_mass: 1 kg, anchors: [[0, 0]]}\n"),
             Catch::Contains("link 1 has no length, its pin lies on its anchor"));
}

TEST_CASE("What is no linkage is refused with the reason") {
  const auto error = [](const std::string& parameters) {
    return error_of(head + "  rig: {block: Linkage, force: 0 N, " + parameters + "}\n");
  };
  CHECK_THAT(error("anchors: [[0, 0, 0, 1]], pin_mass: 1 kg"),
             Catch::Contains("rig.anchors") && Catch::Contains("4 columns"));
  CHECK_THAT(error("anchors: [[0, 1]], pin_mass: 0 kg"),
             Catch::Contains("rig.pin_mass") && Catch::Contains("mass in every direction"));
  CHECK_THAT(error("anchors: [[0, 1]], pin_mass: 0 kg, rod_mass: 1 kg"), Catch::Contains("rig.pin_mass"));
  CHECK(error("anchors: [[0, 1]], pin_mass: 0 kg, rod_mass: 1 kg, housing_inertia: 1e-3").empty());
  CHECK_THAT(error("anchors: [[0, 1]], pin_mass: 1 kg, shortest: 2 m, longest: 1 m"),
             Catch::Contains("rig.shortest"));
  CHECK_THAT(error("anchors: [[0, 1], [1, 1]], pin_mass: 1 kg, rod_mass: [1 kg, 1 kg, 1 kg]"),
             Catch::Contains("rod_mass") && Catch::Contains("3 elements"));
}
