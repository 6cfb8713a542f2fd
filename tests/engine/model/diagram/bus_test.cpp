// Buses: signals under names, of which the plan knows none.
#include <catch2/catch.hpp>

#include "tests/support/plan_text.hpp"
#include "tests/support/run_text.hpp"

namespace stepwire::diagram {

namespace {

using Lines = std::vector<std::string>;

const std::string sources =
    "stepwire: 1\nstep: 1 s\nstop: 3 s\nblocks:\n"
    "  f: {block: Constant, value: {value: [1, 2, 3], unit: N}}\n"
    "  t: {block: Constant, value: {value: [4, 5, 6], unit: N m}}\n"
    "  wrench: {fields: {force: f, torque: t}}\n";

table::Table run(const std::string& text) {
  DiagramFolder folder;
  folder.write("test.yaml", text);
  return folder.run("test.yaml");
}

/// A part that gives the bus it takes, a tick later.
const std::string late_bus =
    "stepwire: 1\ntitle: p\ninputs: {in: {fields: {force: N, torque: N m}}}\noutputs: {out: late}\n"
    "blocks:\n  late: {block: UnitDelay, u: in}\n";

}  // namespace

TEST_CASE("a field of a bus is read as a signal, with its elements") {
  const table::Table table = run(sources +
                                 "  g: {block: Gain, u: wrench.torque.2, gain: 2}\n"
                                 "record: [g, wrench]\n");
  CHECK(column(table, "g").back() == 10.0);
  CHECK(column(table, "wrench.force.3").back() == 3.0);
  CHECK(column(table, "wrench.torque.1").back() == 4.0);
  CHECK(table.find("wrench.force.1")->unit == "N");
}

TEST_CASE("buses stand in buses") {
  const table::Table table = run(sources +
                                 "  load: {fields: {wrench: wrench, place: {fields: {x: f.1, y: f.2}}}}\n"
                                 "  s: {block: Sum, u: [load.place.y, load.wrench.force.3]}\n"
                                 "record: [s, load]\n");
  CHECK(column(table, "s").back() == 5.0);
  CHECK(column(table, "load.wrench.torque.3").back() == 6.0);
  CHECK(column(table, "load.place.x").back() == 1.0);
}

TEST_CASE("a block that passes any signal on is copied for every field of a bus") {
  const std::string text =
      sources +
      "  none: {fields: {force: {value: [0, 0, 0], unit: N}, torque: {value: [0, 0, 0], unit: N m}}}\n"
      "  late: {block: Step, time: 1 s}\n"
      "  chosen: {block: Switch, control: late, threshold: 0.5, then: wrench, else: held}\n"
      "  held: {block: UnitDelay, u: chosen}\n"
      "record: [chosen, held]\n";
  DiagramFolder folder;
  folder.write("test.yaml", text);
  CHECK(folder.plan("test.yaml").blocks.size() == 7);  // f, t, late and two copies of each
  const table::Table table = folder.run("test.yaml");
  CHECK(column(table, "chosen.force.2") == std::vector<double>{0, 2, 2, 2});
  CHECK(column(table, "held.torque.3") == std::vector<double>{0, 0, 6, 6});
}

TEST_CASE("blocks that pass a bus to each other find its fields, in whatever order they stand") {
  const table::Table table =
      run(sources +
          "  a: {block: UnitDelay, u: b}\n"
          "  b: {block: Switch, control: late, threshold: 0.5, then: a, else: c}\n"
          "  c: {block: UnitDelay, u: d}\n"
          "  d: {block: Switch, control: late, threshold: 0.5, then: c, else: wrench}\n"
          "  late: {block: Step, time: 2 s}\n"
          "record: [b, d]\n");
  CHECK(column(table, "d.force.2") == std::vector<double>{2, 2, 2, 2});
  CHECK(column(table, "b.torque.3") == std::vector<double>{0, 6, 6, 6});
}

TEST_CASE("a bus with more fields than a diagram may have is refused at once") {
  std::string text = sources + "  v0: {fields: {a: f, b: t}}\n";
  for (int k = 1; k < 60; ++k) {
    const std::string inner = "v" + std::to_string(k - 1);
    text += "  v" + std::to_string(k) + ": {fields: {a: " + inner + ", b: " + inner + "}}\n";
  }
  DiagramFolder folder;
  folder.write("test.yaml", text + "record: [v59]\n");
  const Lines faults = folder.faults("test.yaml");
  REQUIRE(faults.size() == 1);
  CHECK(faults[0].find("more than 1000 fields") != std::string::npos);
}

TEST_CASE("a part takes and gives buses, and holds them to the fields that it declares") {
  DiagramFolder folder;
  folder.write("part.yaml",
               "stepwire: 1\ninputs: {wrench: {fields: {force: {unit: N, shape: 3}, torque: N m}}}\n"
               "outputs: {out: {signal: held, fields: {force: N}}}\n"
               "blocks: {held: {block: ZeroOrderHold, u: wrench}}\n");
  folder.write("good.yaml", sources +
                                "  a: {diagram: part.yaml, wrench: wrench}\n"
                                "  b: {diagram: part.yaml, wrench: {force: f, torque: t}}\n"
                                "record: [a.out, b.out.torque.2]\n");
  const table::Table table = folder.run("good.yaml");
  CHECK(column(table, "a.out.force.3").back() == 3.0);
  CHECK(column(table, "b.out.torque.2").back() == 5.0);
  folder.write("unit.yaml",
               sources + "  a: {diagram: part.yaml, wrench: {force: t, torque: t}}\nrecord: [a.out]\n");
  REQUIRE_FALSE(folder.faults("unit.yaml").empty());
  CHECK_THAT(folder.faults("unit.yaml")[0], Catch::Contains("a.wrench.force") && Catch::Contains("N m"));
  folder.write("field.yaml", sources + "  a: {diagram: part.yaml, wrench: {force: f}}\nrecord: [a.out]\n");
  REQUIRE_FALSE(folder.faults("field.yaml").empty());
  CHECK_THAT(folder.faults("field.yaml")[0], Catch::Contains("torque"));
}

TEST_CASE("the only output of a part goes by the part's name, also where it is a bus") {
  DiagramFolder folder;
  folder.write("part.yaml", late_bus);
  folder.write("test.yaml", sources +
                                "  p: {diagram: part.yaml, in: wrench}\n"
                                "  h: {block: UnitDelay, u: p}\n"
                                "  g: {block: Gain, u: p.torque.3, gain: 1}\n"
                                "record: [p, h, g]\n");
  const table::Table table = folder.run("test.yaml");
  CHECK(column(table, "p.force.2") == std::vector<double>{0, 2, 2, 2});
  CHECK(column(table, "h.torque.3") == std::vector<double>{0, 0, 6, 6});
  CHECK(column(table, "g") == column(table, "p.torque.3"));
}

TEST_CASE("a part on condition that gives a bus shows a value of its own in every field while it is off") {
  DiagramFolder folder;
  folder.write("part.yaml", late_bus);
  folder.write("test.yaml",
               sources +
                   "  p: {diagram: part.yaml, in: wrench, enable: {when: time < 2 s, outputs: reset}}\n"
                   "  g: {block: Gain, u: p.out.torque.3, gain: 1}\n"
                   "record: [p.out, g]\n");
  const table::Table table = folder.run("test.yaml");
  CHECK(column(table, "p.out.force.2") == std::vector<double>{0, 2, 0, 0});
  CHECK(column(table, "g") == std::vector<double>{0, 6, 0, 0});
}

TEST_CASE("what takes one signal refuses a bus and names its fields") {
  DiagramFolder folder;
  folder.write("test.yaml",
               sources + "  a: {block: Norm, u: wrench}\n  b: {block: Gain, u: wrench.forse}\nrecord: [a]\n");
  const Lines faults = folder.faults("test.yaml");
  REQUIRE(faults.size() == 2);
  CHECK_THAT(faults[0], Catch::Contains("force, torque"));
  CHECK_THAT(faults[1], Catch::Contains("no field 'forse'") && Catch::Contains("force"));
}

TEST_CASE("a matrix on a wire keeps its rows and columns, and a port may demand them") {
  DiagramFolder folder;
  folder.write(
      "part.yaml",
      "stepwire: 1\ninputs: {R: {shape: 3 x 3}}\noutputs: {y: g}\nblocks: {g: {block: Gain, u: R}}\n");
  folder.write("bad.yaml",
               "stepwire: 1\nstep: 1 s\nstop: 1 s\nblocks: {R: {block: Constant, value: [[1, 2], [3, 4]]},"
               " p: {diagram: part.yaml, R: R}}\nrecord: [p.y]\n");
  REQUIRE(folder.faults("bad.yaml").size() == 1);
  CHECK_THAT(folder.faults("bad.yaml")[0], Catch::Contains("3 x 3") && Catch::Contains("2 x 2"));
}

}  // namespace stepwire::diagram
