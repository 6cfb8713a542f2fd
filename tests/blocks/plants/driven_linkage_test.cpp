#include <catch2/catch.hpp>
#include <cmath>

#include "tests/support/run_text.hpp"

using namespace stepwire;

namespace {

const std::string rig =
    "anchors: [[-0.16, 0.36, 0.02], [0.16, 0.36, -0.03], [0, 0.2, 0.22]], pin_mass: 0.8 kg, rod_mass: [0.2, "
    "0.3, 0.5], rod_inertia: [2e-4, 3e-4, 5e-4], rod_centre: [60 mm, 50 mm, 80 mm], housing_inertia: [1e-3, "
    "2e-3, 3e-3]";

/// Position, velocity and acceleration of a closed curve in space, 20 mm wide, around (0, 0.2, 0).
const std::string curve = R"(
  p: {block: Sine, amplitude: [0.02, 0.015, 0.01], frequency: [2, 3, 1], phase: [0, 1, 2], bias: [0, 0.2, 0]}
  v: {block: Sine, amplitude: [0.2513274122871834, 0.2827433388230814, 0.06283185307179587], frequency: [2, 3, 1],
      phase: [1.5707963267948966, 2.5707963267948966, 3.5707963267948966]}
  a: {block: Sine, amplitude: [3.158273408348595, 5.329586376588253, 0.3947841760435743], frequency: [2, 3, 1],
      phase: [3.141592653589793, 4.141592653589793, 5.141592653589793]}
)";

}  // namespace

TEST_CASE("The force that a driven linkage asks for makes a free one move alike") {
  const double w[] = {4.0 * M_PI, 6.0 * M_PI, 2.0 * M_PI}, amplitude[] = {0.02, 0.015, 0.01},
               phase[] = {0, 1, 2};
  std::string start = ", initial_position: [", rates = "], initial_velocity: [";
  for (int i = 0; i < 3; ++i) {
    start += std::to_string(amplitude[i] * std::sin(phase[i]) + (i == 1 ? 0.2 : 0.0)) + (i < 2 ? "," : "");
    rates += std::to_string(w[i] * amplitude[i] * std::cos(phase[i])) + (i < 2 ? "," : "");
  }
  const table::Table table = run_text("step: 0.1 ms\nstop: 0.5 s\nsolver: rk4\nblocks:" + curve + R"(
  f:      {block: Sine, amplitude: [3, 2, 4], frequency: [5, 2, 3]}
  driven: {block: DrivenLinkage, position: p, velocity: v, acceleration: a, force: f, )" +
                                      rig + R"(}
  free:   {block: Linkage, force: f, external: driven.external, )" +
                                      rig + start + rates + R"(]}
record: [p, free.position, driven.kinetic_energy, free.kinetic_energy]
)");
  for (const std::string i : {".1", ".2", ".3"}) {
    const auto &wanted = column(table, "p" + i), &position = column(table, "free.position" + i);
    for (std::size_t k = 0; k < wanted.size(); k += 100) CHECK(std::abs(wanted[k] - position[k]) < 2e-6);
  }
}

TEST_CASE("The work of what drives a linkage, less that of its links, is its kinetic energy") {
  const table::Table table = run_text("step: 0.1 ms\nstop: 0.5 s\nsolver: rk4\nblocks:" + curve + R"(
  driven:  {block: DrivenLinkage, position: p, velocity: v, acceleration: a, force: damping, )" +
                                      rig + R"(}
  damping: {block: Gain, u: driven.rate, gain: -20 N s/m}
  hand:    {block: Dot, u: [driven.external, v]}
  links:   {block: Dot, u: [damping, driven.rate]}
  power:   {block: Sum, u: [hand, links]}
  work:    {block: Integrator, u: power}
record: [work, driven.kinetic_energy]
)");
  const auto &work = column(table, "work"), &energy = column(table, "driven.kinetic_energy");
  for (std::size_t k = 0; k < work.size(); ++k) REQUIRE(std::abs(energy[k] - energy[0] - work[k]) < 1e-9);
}

TEST_CASE("A pin driven along a link at constant speed feels that link's force alone") {
  const table::Table table = run_text(R"(
step: 1 ms
stop: 0.5 s
solver: rk4
blocks:
  push: {block: StraightMotion, from: [0.1, 0.1], direction: [3, 4], speed: 10 mm/s}
  rig:  {block: DrivenLinkage, position: push.position, velocity: push.velocity, force: -5 N,
         anchors: [[-0.2, -0.3]], pin_mass: 1 kg, rod_mass: 1 kg, housing_inertia: 1e-3}
record: [rig.external, rig.length, rig.rate]
)");
  CHECK(column(table, "rig.external.1").back() == Approx(3.0).epsilon(1e-12));
  CHECK(column(table, "rig.external.2").back() == Approx(4.0).epsilon(1e-12));
  CHECK(column(table, "rig.length").back() == Approx(0.5 + 0.005).epsilon(1e-12));
  CHECK(column(table, "rig.rate").back() == Approx(0.01).epsilon(1e-12));
}

TEST_CASE("A driven linkage needs no mass, and its stroke is watched") {
  const auto error = [](const std::string& more) {
    return error_of(
        "step: 1 ms\nstop: 1 s\nsolver: rk4\nblocks:\n  rig: {block: DrivenLinkage, position: [0.3 m, 0.4 "
        "m], "
        "velocity: [0 m/s, 0 m/s], force: 0 N, anchors: [[0, 0]]" +
        more + "}\n");
  };
  CHECK(error("").empty());
  CHECK_THAT(error(", longest: 0.4 m"),
             Catch::Contains("link 1 is 0.5 m long, and 0.4 m is its longest (at 0 s)"));
}
