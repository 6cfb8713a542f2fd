#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <catch2/catch.hpp>

#include "tests/support/plan_text.hpp"

namespace stepwire::diagram {

namespace {

const std::string head = "solver: rk4\nblocks:\n  m: {block: Mass, mass: 2 kg, force: 1 N}\n";

/// The unit of each block's first output.
std::map<std::string, std::string> units_of(const std::string& blocks) {
  const plan::Plan plan = plan_text(head + blocks);
  std::map<std::string, std::string> units;
  for (std::size_t b = 0; b < plan.blocks.size(); ++b) {
    const auto& dimension = plan.diagram.output_dimensions[b].at(0);
    units[plan.diagram.blocks[b].name] = dimension ? unit::si_name(*dimension) : "?";
  }
  return units;
}

std::string fault_of(const std::string& blocks) {
  const auto refused = faults_of(head + blocks);
  REQUIRE(refused.size() == 1);
  return refused[0];
}

}  // namespace

TEST_CASE("a wire whose ends have different units is refused, with both ends") {
  CHECK(fault_of("  n: {block: Mass, force: m.velocity}\n") ==
        "test.yaml:4:27: n.force: m.velocity is in m/s, but n.force is in N; connect a signal in N, or put a "
        "Gain in N s/m between them");
  CHECK(fault_of("  n: {block: Mass, force: 3 mm}\n") ==
        "test.yaml:4:27: n.force: the number is in m, but n.force is in N; write it in N");
  CHECK(fault_of("  s: {block: Sum, u: [m.position, m.velocity]}\n") ==
        "test.yaml:4:35: s.u: m.velocity is in m/s, but s.u is in m; connect a signal in m, or put a Gain in "
        "s between them");
  CHECK(fault_of("  i: {block: Integrator, u: m.velocity, initial: 3 N}\n") ==
        "test.yaml:4:50: i.initial: the initial value is in N, but i.initial is in m; write it in m");
}

TEST_CASE("a cure of units holds: the named Gain fits between both ends") {
  const std::string wrong = "  n: {block: Mass, force: m.velocity}\n";
  const std::string fault = fault_of(wrong), before = "put a Gain in ";
  const std::size_t at = fault.find(before) + before.size();
  const std::string unit = fault.substr(at, fault.find(" between") - at);
  CHECK(faults_of(head + "  g: {block: Gain, u: m.velocity, gain: 1 " + unit +
                  "}\n  n: {block: Mass, force: g}\n")
            .empty());
}

TEST_CASE("units pass through the blocks in between") {
  const auto units = units_of(R"(
  gain: {block: Gain, gain: 2 N/m, u: m.position}
  sum: {block: Sum, u: [gain, 3]}
  product: {block: Product, u: [sum, m.velocity]}
  ratio: {block: Divide, numerator: product, denominator: sum}
  integral: {block: Integrator, u: ratio}
  slope: {block: Derivative, tau: 1 ms, u: integral}
  late: {block: UnitDelay, u: slope}
)");
  CHECK(units.at("gain") == "N");
  CHECK(units.at("sum") == "N");
  CHECK(units.at("product") == "W");
  CHECK(units.at("ratio") == "m/s");
  CHECK(units.at("integral") == "m");
  CHECK(units.at("slope") == "m/s");
  CHECK(units.at("late") == "m/s");
}

TEST_CASE("units are found against the direction of the wires as well") {
  const auto units = units_of(R"(
  bare: {block: Constant, value: 3}
  sum: {block: Sum, u: [bare, late]}
  late: {block: UnitDelay, u: sum}
  n: {block: Mass, force: sum}
)");
  CHECK(units.at("bare") == "N");
  CHECK(units.at("late") == "N");
}

TEST_CASE("a wrong unit is refused however far its ends are apart") {
  CHECK_THAT(fault_of("  a: {block: Sum, u: [m.position, 0]}\n  b: {block: Saturation, u: a, upper: 1}\n  n: "
                      "{block: Mass, force: b}\n"),
             Catch::Contains("is in m") && Catch::Contains("is in N"));
}

TEST_CASE("a voltage per angular speed at a frequency is named by both units, with the factor between them") {
  const std::string induced =
      "  speed: {block: Constant, value: 50 Hz}\n  emf: {block: Gain, u: speed, gain: 20 mV s/rad}\n";
  CHECK(fault_of(induced + "  c: {block: Compare, u: emf, operator: greater, to: 1 V}\n") ==
        "test.yaml:6:54: c.to: the number is in V, but V period/rad is meant, and a period has 2*pi rad; "
        "divide by 2*pi with a Gain");
}

TEST_CASE("the units that a part declares for its ports hold at its border") {
  const DiagramFolder folder;
  folder.write("part.yaml",
               "stepwire: 1\ninputs: {f: {unit: N}}\noutputs: {y: {signal: g, unit: m}}\nblocks:\n  g: "
               "{block: Gain, gain: 2, u: f}\n");
  const std::string main = "stepwire: 1\nstep: 1 s\nstop: 1 s\nsolver: rk4\nblocks:\n";
  folder.write("good.yaml", main + "  p: {diagram: part.yaml, f: 3 N}\n  m: {block: Mass, force: 1 N}\n");
  CHECK(folder.faults("good.yaml").empty());
  folder.write("into.yaml",
               main + "  p: {diagram: part.yaml, f: m.velocity}\n  m: {block: Mass, force: 1 N}\n");
  CHECK(folder.faults("into.yaml") ==
        std::vector<std::string>{"into.yaml:6:30: p.f: m.velocity is in m/s, but p.f is in N; connect a "
                                 "signal in N, or put a Gain in N s/m between them"});
  folder.write("out.yaml", main + "  p: {diagram: part.yaml, f: 3 N}\n  m: {block: Mass, force: p}\n");
  const auto out = folder.faults("out.yaml");
  REQUIRE(out.size() == 1);
  CHECK_THAT(out[0], Catch::Contains("is in m") && Catch::Contains("is in N"));
}

TEST_CASE("one wrong unit is told once, however many wires it contradicts") {
  CHECK(fault_of("  s: {block: Sum, u: [m.position, 3 N, 4 N]}\n  n: {block: Mass, force: s}\n") ==
        "test.yaml:4:35: s.u: the number is in N, but s.u is in m; write it in m");
}

TEST_CASE("the condition that ends a run compares what has one unit") {
  const std::string wire = "  n: {block: Mass, force: 1 N}\nstop_when: ";
  CHECK(fault_of(wire + "n.position > 2 N\n") ==
        "test.yaml:5:12: stop_when: '>' joins m and N; they must have the same unit");
  CHECK(fault_of(wire + "n.position - time < 0\n") ==
        "test.yaml:5:12: stop_when: '-' joins m and s; they must have the same unit");
}

TEST_CASE("a number that is a ratio here and an angle there is both in each order of the blocks") {
  std::vector<std::string> blocks{"angle: {block: Sum, u: [{value: 1, unit: rad}, late]}",
                                  "late: {block: TransportDelay, u: sum, delay: 1 s}",
                                  "rate: {block: Gain, u: late, gain: 3 Hz}",
                                  "sum: {block: Integrator, u: rate}"};
  do {
    const std::string text = fmt::format("{}", fmt::join(blocks, "\n  "));
    INFO(text);
    CHECK(faults_of("solver: rk4\nunits: {sum: \"1\"}\nblocks:\n  " + text + "\n").empty());
  } while (std::next_permutation(blocks.begin(), blocks.end()));
}

}  // namespace stepwire::diagram
