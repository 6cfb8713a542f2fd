#include <catch2/catch.hpp>
#include <cstdlib>

#include "tests/support/plan_text.hpp"
#include "tests/support/run_text.hpp"

namespace stepwire::diagram {

namespace {

const std::string head = "stepwire: 1\nstep: 1 s\nstop: 1 s\n";
using Lines = std::vector<std::string>;

}  // namespace

TEST_CASE("a fault inside of a part names the part's file, then every line that uses it") {
  const DiagramFolder folder;
  folder.write("inner.yaml", "stepwire: 1\nblocks:\n  g: {block: Gain, gain: [[1], [2, 3]], u: 1}\n");
  folder.write("outer.yaml", "stepwire: 1\nblocks:\n  in: {diagram: inner.yaml}\n");
  folder.write("main.yaml", head + "blocks:\n  out: {diagram: outer.yaml}\n");
  CHECK(folder.faults("main.yaml") ==
        Lines{"inner.yaml:3:32: out.in.g.gain: this row has 2 numbers, the first has 1 "
              "(used by outer.yaml:3:17) (used by main.yaml:5:18)"});
}

TEST_CASE("a part whose file is missing or no YAML is the only fault") {
  const DiagramFolder folder;
  folder.write("broken.yaml", "stepwire: 1\nblocks: {a: [\n");
  folder.write("main.yaml", head +
                                "blocks:\n  p: {diagram: nowhere.yaml}\n  q: {diagram: broken.yaml}\n  g: "
                                "{block: Sum, u: [p, q.y]}\nrecord: [p, q.z]\n");
  const auto refused = folder.faults("main.yaml");
  REQUIRE(refused.size() == 2);
  CHECK(refused[0] == "main.yaml:5:16: p: nowhere.yaml: no such file");
  CHECK_THAT(refused[1], Catch::StartsWith("broken.yaml:") && Catch::Contains("(used by main.yaml:6:16)"));
}

TEST_CASE("files that use each other in a circle are refused with the circle") {
  const DiagramFolder folder;
  folder.write("a.yaml", head + "blocks:\n  b: {diagram: b.yaml}\n");
  folder.write("b.yaml", "stepwire: 1\nblocks:\n  a: {diagram: a.yaml}\n");
  const auto refused = folder.faults("a.yaml");
  REQUIRE(refused.size() == 1);
  CHECK(refused[0] ==
        "b.yaml:3:16: b.a: this file contains itself: a.yaml -> b.yaml -> a.yaml; a part cannot use a file "
        "that uses it (used by a.yaml:5:16)");
}

TEST_CASE("a chain of files that is too deep is refused, and one that is not runs") {
  const DiagramFolder folder;
  for (int i = 0; i < 50; ++i)
    folder.write("p" + std::to_string(i) + ".yaml",
                 head + "outputs: {y: n}\nblocks:\n  n: {diagram: p" + std::to_string(i + 1) + ".yaml}\n");
  folder.write("p50.yaml", "stepwire: 1\noutputs: {y: c}\nblocks:\n  c: {block: Constant, value: 3}\n");
  CHECK(folder.faults("p25.yaml").empty());
  const auto refused = folder.faults("p0.yaml");
  REQUIRE(refused.size() == 1);
  CHECK_THAT(refused[0],
             Catch::StartsWith("p31.yaml:6:16: n.n.") &&
                 Catch::Contains("parts are nested more than 32 deep here (used by p30.yaml:6:16)"));
}

TEST_CASE("what a part has not is refused at the key, and what it needs at the map that lacks it") {
  const DiagramFolder folder;
  folder.write("part.yaml",
               "stepwire: 1\nparameters: {mass: 1}\ninputs: {force: {unit: N}}\nblocks:\n  g: {block: Gain, "
               "gain: $mass, u: force}\n");
  folder.write("main.yaml", head + "blocks:\n  p: {diagram: part.yaml, mas: 3}\n");
  CHECK(folder.faults("main.yaml") ==
        Lines{"main.yaml:5:6: p: the input 'force' is missing",
              "main.yaml:5:27: p: part.yaml has no 'mas'; did you mean 'mass'? It has: mass, force"});
}

TEST_CASE("a part's own head is checked where it is used") {
  const DiagramFolder folder;
  folder.write("part.yaml", "stepwire: 1\noutput: {y: g}\ninputs: [u]\nblocks:\n  g: {block: Gain, u: 1}\n");
  folder.write("main.yaml", head + "blocks:\n  p: {diagram: part.yaml}\n");
  const auto refused = folder.faults("main.yaml");
  REQUIRE(refused.size() == 2);
  CHECK_THAT(refused[0],
             Catch::StartsWith("part.yaml:2:1: a diagram has no 'output'; did you mean 'outputs'?"));
  CHECK_THAT(refused[1], Catch::StartsWith("part.yaml:3:9: p.inputs: must be a map of the ports' names"));
}

TEST_CASE("an input of a part may have a default, and a part be run by itself with it") {
  const DiagramFolder folder;
  folder.write("part.yaml", head +
                                "inputs: {u: {default: 4}, v: {}}\noutputs: {y: g}\nblocks:\n  g: {block: "
                                "Sum, u: [u, v]}\nrecord: g\n");
  folder.write("main.yaml", head +
                                "blocks:\n  p: {diagram: part.yaml, v: 1}\n  q: {diagram: part.yaml, v: 1, "
                                "u: 2}\nrecord: [p, q]\n");
  const table::Table run = folder.run("main.yaml");
  CHECK(column(run, "p").front() == 5.0);
  CHECK(column(run, "q").front() == 3.0);
  CHECK(
      folder.faults("part.yaml") ==
      Lines{"part.yaml:4:27: v: nothing feeds this input; use this file as a part, or give it a 'default:'"});
}

TEST_CASE("ports that are wired to each other only are refused") {
  const DiagramFolder folder;
  folder.write("through.yaml",
               "stepwire: 1\ninputs: {u: {}}\noutputs: {y: u}\nblocks:\n  g: {block: Gain, u: u}\n");
  folder.write("main.yaml",
               head + "blocks:\n  p: {diagram: through.yaml, u: q}\n  q: {diagram: through.yaml, u: p}\n");
  const auto refused = folder.faults("main.yaml");
  REQUIRE(!refused.empty());
  for (const std::string& line : refused)
    CHECK_THAT(line, Catch::Contains("wired to itself through ports only"));
}

TEST_CASE("what is wrongly wired to a part is refused at the wire, once, however often the part reads it") {
  const DiagramFolder folder;
  folder.write("part.yaml",
               "stepwire: 1\ninputs: {u: {}}\noutputs: {y: a}\nblocks:\n"
               "  a: {block: Gain, u: u}\n  b: {block: Sum, u: [u, u]}\n");
  folder.write("main.yaml", head + "blocks:\n  p: {diagram: part.yaml, u: nowhere}\n");
  CHECK(folder.faults("main.yaml") == Lines{"main.yaml:5:30: p.u: there is no block 'nowhere'"});
}

TEST_CASE("ends that do not fit are refused at the wire, whether it enters a part or leaves one") {
  const DiagramFolder folder;
  const std::string mass = "  m: {block: Mass, force: ";
  folder.write("part.yaml",
               "stepwire: 1\ninputs: {f: {}}\noutputs: {v: m.velocity}\nblocks:\n" + mass + "f}\n");
  folder.write("main.yaml",
               head + "solver: rk4\nblocks:\n  p: {diagram: part.yaml, f: 3 N}\n" + mass + "p}\n");
  CHECK(folder.faults("main.yaml") ==
        Lines{"main.yaml:7:27: m.force: p.m.velocity is in m/s, but m.force is in N; connect a signal in N, "
              "or put a Gain in N s/m between them"});
  folder.write("in.yaml",
               head + "solver: rk4\nblocks:\n" + mass + "1 N}\n  p: {diagram: part.yaml, f: m.position}\n");
  CHECK(folder.faults("in.yaml") == Lines{"in.yaml:7:30: p.m.force: m.position is in m, but p.m.force is in "
                                          "N; connect a signal in N, or put a Gain in N/m between them"});
}

TEST_CASE("a part that is not beside its user is found in the first folder of STEPWIRE_PARTS that has it") {
  const std::string part = "stepwire: 1\noutputs: {y: c}\nblocks:\n  c: {block: Constant, value: ";
  const DiagramFolder users, first, second;
  users.write("main.yaml", head +
                               "blocks:\n  a: {diagram: one.yaml}\n  b: {diagram: two.yaml}\n  c: {diagram: "
                               "three.yaml}\nrecord: [a.y, b.y, c.y]\n");
  users.write("three.yaml", part + "30}\n");
  first.write("one.yaml", part + "1}\n");
  first.write("three.yaml", part + "31}\n");
  second.write("one.yaml", part + "10}\n");
  second.write("two.yaml", part + "20}\n");
  const std::string folders = first.path("") + ":" + second.path("");
  ::setenv("STEPWIRE_PARTS", folders.c_str(), 1);
  const table::Table run = users.run("main.yaml");
  users.write("none.yaml", head + "blocks:\n  a: {diagram: nowhere.yaml}\n");
  const auto refused = users.faults("none.yaml");
  ::unsetenv("STEPWIRE_PARTS");
  CHECK(column(run, "a.y").back() == 1.0);
  CHECK(column(run, "b.y").back() == 20.0);
  CHECK(column(run, "c.y").back() == 30.0);
  REQUIRE(refused.size() == 1);
  CHECK_THAT(refused[0], Catch::Contains("no such file, nor in ") && Catch::Contains(first.path("")));
}

TEST_CASE("parts that come with the program are named by stepwire/") {
  const DiagramFolder folder;
  folder.write(
      "main.yaml",
      head + "blocks:\n  swing: {diagram: stepwire/oscillator, force: 1 N}\nsolver: rk4\nrecord: swing.x\n");
  CHECK(folder.faults("main.yaml").empty());
}

TEST_CASE(
    "a misspelt part is refused with the nearest name beside its user, of the program, and of folders") {
  const DiagramFolder users, folder;
  const auto refusal = [&](const std::string& path) {
    users.write("main.yaml", head + "blocks:\n  a: {diagram: " + path + "}\n");
    const auto refused = users.faults("main.yaml");
    REQUIRE(refused.size() == 1);
    return refused[0];
  };
  users.write("bench.yaml", "stepwire: 1\n");
  folder.write("spindle.yaml", "stepwire: 1\n");
  ::setenv("STEPWIRE_PARTS", folder.path("").c_str(), 1);
  const std::string listed = refusal("spindel.yaml");
  ::unsetenv("STEPWIRE_PARTS");
  CHECK_THAT(listed, Catch::EndsWith("; did you mean 'spindle.yaml'?"));
  CHECK(refusal("bensh.yaml") == "main.yaml:5:16: a: bensh.yaml: no such file; did you mean 'bench.yaml'?");
  CHECK_THAT(refusal("stepwire/oscilator"), Catch::EndsWith("; did you mean 'stepwire/oscillator'?"));
  CHECK_THAT(refusal("stepwire/oscilator.yaml"),
             Catch::EndsWith("; did you mean 'stepwire/oscillator.yaml'?"));
  CHECK_THAT(refusal("gearbox-of-none.yaml"), Catch::EndsWith("no such file"));
}

}  // namespace stepwire::diagram
