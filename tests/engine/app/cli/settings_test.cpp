#include <catch2/catch.hpp>

#include "tests/engine/app/cli/program.hpp"

namespace {

const std::string rig = R"(stepwire: 1
title: a rig of units
step: 1 ms
stop: 2 ms
parameters:
  length: 3 m
blocks:
  bath: {block: Constant, value: 30 degC}
  wheel: {block: Constant, value: 20 rpm}
  places: {block: Constant, value: [3 mm, 4 mm]}
  ratio: {block: Constant, value: 3}
  arm: {block: Constant, value: $length}
  body: {block: Mass, mass: 2 kg, force: 1 N, initial_position: 3 mm}
record: [bath, wheel, places, ratio, arm, body.position]
solver: rk4
claims:
  - that: the bath is cold
    final: bath
    equals: -243.15 degC
    within: 1e-9 K
)";

Done run_with(const Scratch& folder, const std::string& setting) {
  folder.file("rig.yaml", rig);
  return run_program(folder, {"run", "rig.yaml", "--set", setting});
}

/// Returns the name, value and unit that a run prints of a setting; "" if it prints none.
std::string echo_of(const std::string& setting) {
  const Scratch folder;
  const Done done = run_with(folder, setting);
  INFO(done.err);
  REQUIRE(done.code <= 1);
  for (const std::string& line : lines_of(done.out))
    if (line.starts_with("  set  ")) return line.substr(7);
  return "";
}

}  // namespace

TEST_CASE("a run prints the SI unit of a setting without one") {
  CHECK(echo_of("length=4") == "length = 4 m");
  CHECK(echo_of("bath.value=30") == "bath.value = 30 K");
  CHECK(echo_of("bath.value=0") == "bath.value = 0 K");
  CHECK(echo_of("wheel.value=20") == "wheel.value = 20 rad/s");
  CHECK(echo_of("wheel.value=2*10") == "wheel.value = 2*10 rad/s");
  CHECK(echo_of("places.value=[5, 6e-3]") == "places.value = [5, 6e-3] m");
  CHECK(echo_of("places.value=[0.005 m, 6e-3]") == "places.value.2 = 6e-3 m");
  CHECK(echo_of("body.mass=3") == "body.mass = 3 kg");
  CHECK(echo_of("body.initial_position=3") == "body.initial_position = 3 m");
}

TEST_CASE("a setting with its unit, a pure number and a zero are not printed") {
  for (const char* setting : {"length=4 mm", "bath.value=30 degC", "wheel.value=20rpm", "ratio.value=4",
                              "wheel.value=0", "places.value=[5 mm, 6 mm]", "wheel.value=2 rpm + 3 rpm"})
    CHECK(echo_of(setting).empty());
}

TEST_CASE("a setting without unit keeps the unit of the file") {
  const Scratch folder;
  CHECK(run_with(folder, "bath.value=30").code == 0);
  CHECK(run_with(folder, "bath.value=30 degC").code == 1);
  CHECK(run_with(folder, "bath.value=30 m").code == 2);
}
