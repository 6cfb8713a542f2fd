#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <optional>

#include "engine/base/table/table_file.hpp"
#include "tests/engine/base/table/scratch.hpp"
#include "tests/support/run_text.hpp"
#include "tests/support/units/units.hpp"

using namespace stepwire;

namespace {

/// A diagram of one unit.
std::string unit_diagram(const Scratch& scratch, const std::string& kind, const std::string& keys,
                         const std::string& head) {
  const std::string path = testing::write_zip(scratch.path(kind + ".fmu"), testing::unit_of_3(kind));
  return fmt::format("{}\nblocks:\n  unit: {{block: Fmu, file: {}{}}}\n", head, path, keys);
}

/// Returns a reference trajectory of the FMI project; std::nullopt if its folder is missing.
std::optional<table::Table> reference(const std::string& name) {
  const char* data = std::getenv("STEPWIRE_DATA");
  const std::filesystem::path path =
      std::filesystem::path(data ? data : "") / "fmi" / "reference" / (name + "_out.csv");
  if (data && std::filesystem::exists(path)) return table::read_csv(path.string());
  WARN("no " << name << "_out.csv: STEPWIRE_DATA has no folder fmi/reference; not compared");
  return std::nullopt;
}

void require_reference(const table::Table& run, const std::string& name, const std::string& recorded,
                       const std::string& unit_column) {
  const auto known = reference(name);
  if (!known) return;
  const auto& expected = column(*known, unit_column);
  const auto& shown = column(run, recorded);
  REQUIRE(shown.size() >= expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    INFO(name << " row " << i);
    CHECK(shown[i] == expected[i]);
  }
}

}  // namespace

TEST_CASE("co-simulation of Dahlquist meets the trajectory of the FMI project") {
  const Scratch scratch;
  const auto run =
      run_text(unit_diagram(scratch, "dahlquist", "", "step: 0.1 s\nstop: 10 s") + "record: [unit.x]\n");
  CHECK(column(run, "unit.x")[1] == 0.9);
  require_reference(run, "Dahlquist", "unit.x", "x");
}

TEST_CASE("co-simulation of the bouncing ball meets the trajectory of the FMI project") {
  const Scratch scratch;
  const auto run =
      run_text(unit_diagram(scratch, "ball", "", "step: 10 ms\nstop: 3 s") + "record: [unit.h, unit.v]\n");
  require_reference(run, "BouncingBall", "unit.h", "h");
  require_reference(run, "BouncingBall", "unit.v", "v");
}

TEST_CASE("a unit in a process of its own has the same bits") {
  const Scratch scratch;
  const std::string head = "step: 10 ms\nstop: 3 s";
  const auto inside =
      run_text(unit_diagram(scratch, "ball", ", isolate: false", head) + "record: [unit.h]\n");
  const auto isolated =
      run_text(unit_diagram(scratch, "ball", ", isolate: true", head) + "record: [unit.h]\n");
  CHECK(column(inside, "unit.h") == column(isolated, "unit.h"));
}

TEST_CASE("states of model exchange are integrated by the solver of the diagram") {
  const Scratch scratch;
  const auto run =
      run_text(unit_diagram(scratch, "dahlquist", ", interface: model_exchange, parameters: {k: 2 1/s}",
                            "step: 10 ms\nstop: 1 s\nsolver: rk4") +
               "record: [unit.x]\n");
  CHECK(column(run, "unit.x").back() == Approx(std::exp(-2.0)).epsilon(1e-8));
}

TEST_CASE("explicit Euler of model exchange has the bits of the unit's own Euler") {
  const Scratch scratch;
  const auto run = run_text(unit_diagram(scratch, "dahlquist", ", interface: model_exchange",
                                         "step: 0.1 s\nstop: 10 s\nsolver: euler") +
                            "record: [unit.x]\n");
  require_reference(run, "Dahlquist", "unit.x", "x");
}

TEST_CASE("an event of model exchange is located: a ball bounces where its fall ends") {
  const Scratch scratch;
  const auto run = run_text(unit_diagram(scratch, "ball", ", interface: model_exchange, parameters: {e: 0.8}",
                                         "step: 10 ms\nstop: 0.6 s\nsolver: rk4\nevents: locate") +
                            "record: [unit.h, unit.v]\n");
  const double fall = std::sqrt(2.0 / 9.81), after = 0.6 - fall, up = 0.8 * 9.81 * fall;
  CHECK(column(run, "unit.h").back() == Approx(up * after - 0.5 * 9.81 * after * after).epsilon(1e-6));
  CHECK(column(run, "unit.v").back() == Approx(up - 9.81 * after).epsilon(1e-6));
}

TEST_CASE("time events of model exchange come at their time") {
  const Scratch scratch;
  const auto run = run_text(unit_diagram(scratch, "stair", ", interface: model_exchange",
                                         "step: 50 ms\nstop: 2.4 s\nsolver: rk4\nevents: locate") +
                            "record: [unit.counter]\n");
  const auto& counter = column(run, "unit.counter");
  CHECK(counter[19] == 1.0);
  CHECK(counter[21] == 2.0);
  CHECK(counter[41] == 3.0);
}

TEST_CASE(
    "a time event of model exchange on a tick is in the row of the tick, as in the published reference") {
  const Scratch scratch;
  for (const std::string events : {"", "\nevents: locate"}) {
    const auto run = run_text(unit_diagram(scratch, "stair", ", interface: model_exchange",
                                           "step: 0.2 s\nstop: 2.4 s\nsolver: rk4" + events) +
                              "  x: {block: Integrator, u: unit.counter}\nrecord: [unit.counter, x]\n");
    const auto& counter = column(run, "unit.counter");
    CHECK(counter[4] == 1.0);
    CHECK(counter[5] == 2.0);
    CHECK(counter[9] == 2.0);
    CHECK(counter[10] == 3.0);
    CHECK(column(run, "x").back() == Approx(1.0 + 2.0 + 3.0 * 0.4));
  }
}

TEST_CASE("a time event of a unit without states is located between ticks, beside blocks that read it") {
  const Scratch scratch;
  const auto run = run_text(unit_diagram(scratch, "stair", ", interface: model_exchange",
                                         "step: 300 ms\nstop: 2.4 s\nsolver: rk4\nevents: locate") +
                            "  x: {block: Integrator, u: unit.counter}\nrecord: [unit.counter, x]\n");
  CHECK(column(run, "unit.counter")[3] == 1.0);  // at 0.9 s
  CHECK(column(run, "unit.counter")[4] == 2.0);
  CHECK(column(run, "x").back() == Approx(1.0 + 2.0 + 3.0 * 0.4));
}

TEST_CASE("a unit hands over every type of number") {
  const Scratch scratch;
  std::string keys;
  for (const char* type : {"Float64", "Float32", "Int8", "UInt8", "Int16", "UInt16", "Int32", "UInt32",
                           "Int64", "UInt64", "Boolean"})
    keys += fmt::format(", {}_input: source", type);
  const auto run = run_text(unit_diagram(scratch, "feedthrough", keys, "step: 0.1 s\nstop: 1 s") +
                            "  source: {block: Constant, value: 300.4}\nrecord: all\n");
  CHECK(column(run, "unit.Float64_output").back() == 300.4);
  CHECK(column(run, "unit.Float32_output").back() == static_cast<double>(300.4f));
  CHECK(column(run, "unit.Int8_output").back() == 127.0);
  CHECK(column(run, "unit.UInt8_output").back() == 255.0);
  CHECK(column(run, "unit.Int64_output").back() == 300.0);
  CHECK(column(run, "unit.Boolean_output").back() == 1.0);
}

TEST_CASE("numbers of a unit become SI by its factors") {
  const Scratch scratch;
  const auto run = run_text(unit_diagram(scratch, "dahlquist", "", "step: 0.1 s\nstop: 0.1 s") +
                            "record: [unit.shown_mm]\n");
  CHECK(column(run, "unit.shown_mm")[0] == 0.001);
}

TEST_CASE("a fault of a unit ends the run with the block's name and the unit's message") {
  const Scratch scratch;
  for (const char* isolate : {", isolate: false", ", isolate: true"}) {
    const std::string error =
        error_of(unit_diagram(scratch, "fails", isolate, "step: 0.1 s\nstop: 1 s") + "record: [unit.y]\n");
    INFO(error);
    CHECK(error.find("unit") != error.npos);
    CHECK(error.find("the spring has broken") != error.npos);
  }
}

TEST_CASE("a unit that crashes in its own process is a fault of the block") {
  const Scratch scratch;
  const std::string error =
      error_of(unit_diagram(scratch, "crashes", "", "step: 0.1 s\nstop: 1 s") + "record: [unit.y]\n");
  INFO(error);
  CHECK(error.find("its process in fmi3DoStep was ended by signal 11") != error.npos);
}

TEST_CASE("parameters of a unit are held to its names, limits and units") {
  const Scratch scratch;
  const auto refused = [&](const std::string& parameters) {
    return error_of(
        unit_diagram(scratch, "dahlquist", ", parameters: {" + parameters + "}", "step: 0.1 s\nstop: 1 s") +
        "record: [unit.x]\n");
  };
  CHECK(refused("kk: 2").find("did you mean 'k'?") != std::string::npos);
  CHECK(refused("k: -1").find("'k' must be at least 0") != std::string::npos);
  CHECK(refused("k: 2 m").find("has another unit") != std::string::npos);
  CHECK(refused("k: two").find("it must be a number") != std::string::npos);
}
