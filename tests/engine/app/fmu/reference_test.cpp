// Test units of the FMI project, written as our diagrams, exported and imported again. The results agree with
// the published trajectories to the last printed digit.
#include <fmt/format.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <optional>
#include <sstream>

#include "tests/engine/app/fmu/exported.hpp"
#include "tests/support/run_text.hpp"

namespace stepwire::fmu {

namespace {

std::vector<std::string> cells(const std::string& line) {
  std::vector<std::string> cells;
  std::istringstream text(line);
  for (std::string cell; std::getline(text, cell, ',');) cells.push_back(cell);
  return cells;
}

/// Returns a column of a reference trajectory, whose other columns may be text; std::nullopt if it is
/// missing.
std::optional<std::vector<double>> reference(const std::string& name, const std::string& column) {
  const char* data = std::getenv("STEPWIRE_DATA");
  std::ifstream file(std::filesystem::path(data ? data : "") / "fmi" / "reference" / (name + "_out.csv"));
  if (!data || !file) {
    WARN("no " << name << "_out.csv: STEPWIRE_DATA has no folder fmi/reference; not compared");
    return std::nullopt;
  }
  std::string line;
  std::getline(file, line);
  const std::vector<std::string> head = cells(line);
  const auto at = static_cast<std::size_t>(std::find(head.begin(), head.end(), column) - head.begin());
  std::vector<double> numbers;
  while (std::getline(file, line)) numbers.push_back(std::stod(cells(line).at(at)));
  return numbers;
}

/// A unit of FMI: its diagram, how it is stepped, and which of its ports are which column of the trajectory.
struct Reference {
  std::string name, diagram, step, stop;
  std::vector<std::pair<std::string, std::string>> columns;
};

// The ball's h is put just above 0, as the FMI project does it.
const Reference references[] = {
    {"Dahlquist",
     R"(stepwire: 1
title: dx/dt = -k x
step: 0.1 s
stop: 10 s
solver: euler
parameters: {k: 1}
blocks:
  slope: {block: Expression, expression: "-k * u1", u: [x]}
  x:     {block: Integrator, u: slope, initial: 1}
record: [x]
)",
     "0.1 s",
     "10 s",
     {{"x", "x"}}},
    {"VanDerPol",
     R"(stepwire: 1
title: the oscillator of van der Pol
step: 10 ms
stop: 20 s
solver: euler
parameters: {mu: 1}
blocks:
  x0:    {block: Integrator, u: x1, initial: 2}
  slope: {block: Expression, expression: "mu * ((1 - u1 * u1) * u2) - u1", u: [x0, x1]}
  x1:    {block: Integrator, u: slope, initial: 0}
record: [x0, x1]
)",
     "10 ms",
     "20 s",
     {{"x0", "x0"}, {"x1", "x1"}}},
    {"BouncingBall",
     R"(stepwire: 1
title: a ball that bounces
step: 1 ms
stop: 3 s
parameters: {bounce: 0.7, v_min: 0.1}
blocks:
  h: {block: UnitDelay, u: h_new, initial: 1, every: 1 ms}
  v: {block: UnitDelay, u: v_new, initial: 0, every: 1 ms}
  g: {block: UnitDelay, u: g_new, initial: -9.81, every: 1 ms}
  fallen: {block: Expression, expression: "u1 + 0.001 * u2", u: [h, v]}
  faster: {block: Expression, expression: "u1 + 0.001 * u2", u: [v, g]}
  hit:    {block: Expression, expression: "u1 <= 0 && u2 < 0 ? 1 : 0", u: [fallen, faster]}
  rests:  {block: Expression, expression: "u1 > 0 && -u2 * bounce < v_min ? 1 : 0", u: [hit, faster]}
  h_new:  {block: Expression, expression: "u1 > 0 ? 2.2250738585072014e-308 : u2", u: [hit, fallen]}
  v_new:  {block: Expression, expression: "u1 > 0 ? 0 : u2 > 0 ? -u3 * bounce : u3", u: [rests, hit, faster]}
  g_new:  {block: Expression, expression: "u1 > 0 ? 0 : u2", u: [rests, g]}
record: [h, v]
)",
     "10 ms",
     "3 s",
     {{"h", "h"}, {"v", "v"}}},
    {"Stair",
     R"(stepwire: 1
title: a counter, one more each second
step: 0.2 s
stop: 9 s
stop_when: counter >= 10
blocks:
  counter: {block: Expression, expression: "1 + u1", u: [seconds]}
  next:    {block: Expression, expression: "1 + u1", u: [seconds], every: 1 s}
  seconds: {block: UnitDelay, u: next, initial: 0, every: 1 s}
record: [counter]
)",
     "0.2 s",
     "9 s",
     {{"counter", "counter"}}},
    {"Feedthrough",
     R"(stepwire: 1
title: outputs repeat inputs
step: 0.1 s
stop: 2 s
inputs: {Float64_continuous_input: {default: 0}, Int32_input: {default: 0}}
blocks:
  Float64_continuous_output: {block: Gain, u: Float64_continuous_input, gain: 1}
  Int32_output: {block: Gain, u: Int32_input, gain: 1}
record: [Float64_continuous_output, Int32_output]
)",
     "0.1 s",
     "2 s",
     {{"Float64_continuous_output", "Float64_continuous_output"}, {"Int32_output", "Int32_output"}}},
    {"Resource",
     R"(stepwire: 1
title: the code of the first character of a file
step: 1 s
stop: 1 s
blocks: {y: {block: FromFile, file: y.csv, column: code}}
record: [y]
)",
     "1 s",
     "1 s",
     {{"y", "y"}}}};

table::Table imported(const Scratch& folder, const Reference& of, int version) {
  const std::string path = exported(folder, of.name, of.diagram, version);
  std::string recorded;
  for (const auto& [port, csv] : of.columns) recorded += (recorded.empty() ? "" : ", ") + ("unit." + port);
  return run_text(
      fmt::format("step: {}\nstop: {}\nblocks:\n  unit: {{block: Fmu, file: {}, interface: "
                  "co_simulation}}\nrecord: [{}]\n",
                  of.step, of.stop, path, recorded));
}

}  // namespace

TEST_CASE("exported diagrams meet the trajectories of the FMI project", "[full]") {
  if (!there_is_a_compiler()) return;
  const int version = GENERATE(3, 2);
  for (const Reference& of : references) {
    INFO(of.name << " as FMI " << version);
    const Scratch folder;
    folder.file("y.csv", "time [s],code\n0,97\n1,97\n");
    const table::Table run = imported(folder, of, version);
    for (const auto& [port, csv] : of.columns) {
      const auto known = reference(of.name, csv);
      if (!known) continue;
      const std::vector<double>& expected = *known;
      const std::vector<double>& shown = column(run, "unit." + port);
      REQUIRE(shown.size() == expected.size());
      for (std::size_t i = 0; i < expected.size(); ++i) {
        INFO(port << " row " << i);
        CHECK(shown[i] == expected[i]);
      }
    }
  }
}

}  // namespace stepwire::fmu
