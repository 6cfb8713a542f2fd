#include "engine/simulate/replay/verify.hpp"

#include <catch2/catch.hpp>
#include <filesystem>

#include "engine/base/io/file.hpp"
#include "engine/simulate/replay/recorded.hpp"
#include "tests/engine/simulate/replay/left_folder.hpp"

namespace stepwire::replay {

namespace {

const std::string line = R"(stepwire: 1
step: 0.25 s
stop: 1 s
blocks: {t: {block: Clock}, twice: {block: Gain, u: t, gain: 2 m/s}}
record: [{signals: [t, {rig.x: twice}]}, {every: 0.5 s, signals: twice}]
)";

const std::string sweep =
    "stepwire: 1\nstep: 1 s\nstop: 3 s\nparameters: {gain: 1}\n"
    "blocks: {t: {block: Clock}, y: {block: Gain, u: t, gain: $gain}}\nrecord: y\n"
    "sweep: {gain: [1, 10, 100]}\n";

}  // namespace

TEST_CASE("what a run left is found equal, whatever became of the diagram and its data since") {
  const DiagramFolder folder;
  folder.write("rows.csv", "time [s],x\n0,0\n2,2\n");
  folder.write("main.yaml", line + "stop_when: twice > 1.2 m\n");
  leave(folder, "main.yaml", "out");
  std::filesystem::remove(folder.path("main.yaml"));
  CHECK(verdict_of(folder, "out") == "3 signals in 7 rows: all bits agree");
}

TEST_CASE("a changed number is named with its line, signal, time and both values") {
  const DiagramFolder folder;
  folder.write("main.yaml", line);
  leave(folder, "main.yaml", "out");
  REQUIRE(io::read_file(folder.path("out/signals.csv")) ==
          "time [s],t [s],rig.x [m]\n0,0,0\n0.25,0.25,0.5\n0.5,0.5,1\n0.75,0.75,1.5\n1,1,2\n");
  const auto verdict_with = [&](const std::string& what, const std::string& by) {
    leave(folder, "main.yaml", "out");
    change(folder, "out/signals.csv", what, by);
    return verdict_of(folder, "out");
  };
  CHECK(verdict_with("0.75,1.5", "0.75,1.5000000000000002") ==
        "signals.csv:5: rig.x at 0.75 s is 1.5000000000000002 and 1.5 when it is replayed");
  CHECK(verdict_with("0,0,0", "0,0,-0") == "signals.csv:2: rig.x at 0 s is -0 and 0 when it is replayed");
  CHECK(verdict_with("0.25,0.5", "0.25,nan") ==
        "signals.csv:3: rig.x at 0.25 s is nan and 0.5 when it is replayed");
  CHECK(verdict_with("1,1,2", "1,-inf,2") == "signals.csv:6: t at 1 s is -inf and 1 when it is replayed");
  CHECK(verdict_with("0.5,0.5", "0.51,0.5") ==
        "signals.csv:4: time at 0.5 s is 0.51 and 0.5 when it is replayed");
  CHECK(verdict_with("0.5,0.5", "5e-1,0.50") == "3 signals in 8 rows: all bits agree");
  CHECK(verdict_with("1,1,2\n", "1,1,2\n1.25,1,2\n") ==
        "signals.csv:7: there is a row at 1.25 s, but the replay ends at 1 s");
}

TEST_CASE("of several tables the first difference in time counts") {
  const DiagramFolder folder;
  folder.write("main.yaml", line);
  leave(folder, "main.yaml", "out");
  change(folder, "out/signals.csv", "1,1,2", "1,1,3");
  change(folder, "out/signals-2.csv", "0.5,1", "0.5,1.5");
  CHECK(verdict_of(folder, "out") == "signals-2.csv:3: twice at 0.5 s is 1.5 and 1 when it is replayed");
}

TEST_CASE("a changed diagram is found by what it gives") {
  const DiagramFolder folder;
  folder.write("main.yaml", line);
  leave(folder, "main.yaml", "out");
  change(folder, "out/diagram.yaml", "gain: 2 m/s", "gain: 2.5 m/s");
  CHECK(verdict_of(folder, "out") == "signals.csv:3: rig.x at 0.25 s is 0.5 and 0.625 when it is replayed");
}

TEST_CASE(
    "a run is replayed with the functions that its note names, and one without any with the C library's") {
  const DiagramFolder folder;
  const std::string growing =
      "step: 10 ms\nstop: 5 s\nblocks: {t: {block: Clock}, y: {block: Expression, u: t, expression: "
      "exp(u)}}\n"
      "record: y\n";
  const std::string fine = "1 signal in 501 rows: all bits agree", other = "when it is replayed";
  folder.write("main.yaml", "stepwire: 1\nfunctions: libm\n" + growing);
  leave(folder, "main.yaml", "out");
  CHECK(verdict_of(folder, "out") == fine);
  change(folder, "out/run.json", "  \"functions\": \"libm\",\n", "");
  CHECK(verdict_of(folder, "out") == fine);
  change(folder, "out/run.json", "  \"runs\":", "  \"functions\": \"portable\",\n  \"runs\":");
  CHECK_THAT(verdict_of(folder, "out"), Catch::Contains(other));
  folder.write("main.yaml", "stepwire: 1\n" + growing);
  leave(folder, "main.yaml", "out");
  CHECK(verdict_of(folder, "out") == fine);
  change(folder, "out/run.json", "  \"functions\": \"portable\",\n", "");
  CHECK_THAT(verdict_of(folder, "out"), Catch::Contains(other));
}

TEST_CASE("a sweep is replayed with the functions that its note names") {
  const DiagramFolder folder;
  folder.write("main.yaml",
               "stepwire: 1\nfunctions: libm\nstep: 10 ms\nstop: 5 s\nparameters: {rate: 1}\n"
               "blocks: {t: {block: Clock}, y: {block: Expression, u: t, expression: exp($rate*u)}}\n"
               "record: y\nsweep: {rate: [1, 1.1]}\n");
  leave(folder, "main.yaml", "out");
  CHECK_THAT(verdict_of(folder, "out"), Catch::Contains("of 2 runs: all bits agree"));
  change(folder, "out/run.json", "\"functions\": \"libm\"", "\"functions\": \"portable\"");
  CHECK_THAT(verdict_of(folder, "out"), Catch::Contains("when it is replayed"));
}

TEST_CASE("of a run that ended early the rows that are there are compared, without running on") {
  const DiagramFolder folder;
  folder.write("main.yaml", line);
  leave(folder, "main.yaml", "out");
  change(folder, "out/diagram.yaml", "stop: 1 s", "stop: 1e6 s");
  CHECK(verdict_of(folder, "out") == "3 signals in 8 of 6000002 rows: all bits agree; the run ended early");
}

TEST_CASE("a run that broke off by itself is whole") {
  const DiagramFolder folder;
  folder.write("main.yaml",
               "stepwire: 1\nstep: 1 s\nstop: 9 s\nblocks:\n  t: {block: Clock}\n"
               "  left: {block: Sum, signs: \"+-\", u: [2, t]}\n"
               "  y: {block: Divide, numerator: 1, denominator: left}\nrecord: [left, y]\n");
  leave(folder, "main.yaml", "out");
  CHECK(verdict_of(folder, "out") == "2 signals in 2 rows: all bits agree");
}

TEST_CASE("a sweep is compared run by run") {
  const DiagramFolder folder;
  folder.write("main.yaml", sweep);
  leave(folder, "main.yaml", "out");
  CHECK(verdict_of(folder, "out") == "1 signal in 12 rows of 3 runs: all bits agree");
  change(folder, "out/signals.csv", "2,10,20", "2,10,21");
  CHECK(verdict_of(folder, "out") == "signals.csv:8: y at 2 s is 21 and 20 when it is replayed");
}

TEST_CASE("runs of a sweep that are short or missing are told from those that differ") {
  const DiagramFolder folder;
  folder.write("main.yaml", sweep);
  const auto verdict_with = [&](const std::string& what, const std::string& by) {
    leave(folder, "main.yaml", "out");
    change(folder, "out/signals.csv", what, by);
    return verdict_of(folder, "out");
  };
  CHECK(verdict_with("2,10,20\n3,10,30\n", "") ==
        "signals.csv:8: the row at 2 s is missing, and run.json does not say that the run ended before it");
  CHECK(verdict_with("0,100,0\n1,100,100\n2,100,200\n3,100,300\n", "") ==
        "signals.csv:10: the row at 0 s is missing, and run.json does not say that the run ended before it");
  CHECK(verdict_with("3,100,300\n", "3,100,300\n0,100,0\n") ==
        "signals.csv:14: there are more rows than the 3 runs give");
}

TEST_CASE("a run of a sweep that left nothing does not shift the others") {
  const DiagramFolder folder;
  folder.write("main.yaml",
               "stepwire: 1\nstep: 1 s\nstop: 2 s\nparameters: {a: 1}\nblocks:\n  t: {block: Clock}\n"
               "  d: {block: Sum, u: [t, $a]}\n  y: {block: Divide, numerator: 1, denominator: d}\n"
               "record: [y]\nsweep: {a: [1, 0, 2]}\n");
  leave(folder, "main.yaml", "out");
  CHECK(verdict_of(folder, "out") == "1 signal in 6 rows of 3 runs: all bits agree");
}

TEST_CASE("swept words and units of swept parameters do not matter") {
  const DiagramFolder folder;
  folder.write("rows.csv", "time [s],x\n0,1\n2,3\n");
  folder.write("main.yaml",
               "stepwire: 1\nstep: 0.5 s\nstop: 2 s\nparameters: {way: linear, gain: 1 mm}\n"
               "blocks: {a: {block: FromFile, file: rows.csv, column: x, interpolation: $way},\n"
               "         b: {block: Gain, u: a, gain: $gain}}\nrecord: [b]\n"
               "sweep: {way: [hold, linear], gain: [1 mm, 2 mm]}\n");
  leave(folder, "main.yaml", "out");
  CHECK(verdict_of(folder, "out") == "1 signal in 20 rows of 4 runs: all bits agree");
}

TEST_CASE("a folder that is not such a one is refused with what is missing") {
  const DiagramFolder folder;
  folder.write("rows.csv", "time [s],x\n0,1\n2,3\n");
  folder.write("main.yaml",
               "stepwire: 1\nstep: 1 s\nstop: 2 s\nblocks: {a: {block: FromFile, file: rows.csv, column: "
               "x}}\nrecord: a\n");
  const auto verdict_without = [&](const std::string& file) {
    leave(folder, "main.yaml", "out");
    std::filesystem::remove(folder.path("out/" + file));
    return verdict_of(folder, "out");
  };
  CHECK_THAT(verdict_of(folder, "none"), Catch::EndsWith("none: there is no such folder"));
  for (const std::string file : {"signals.csv", "diagram.yaml", "run.json"})
    CHECK_THAT(verdict_without(file), Catch::StartsWith(file + ": is missing; "));
  CHECK_THAT(verdict_without("inputs/rows.csv"),
             Catch::StartsWith("diagram.yaml:") && Catch::Contains("there is no file inputs/rows.csv"));
}

TEST_CASE("a folder that is damaged is refused where it is") {
  const DiagramFolder folder;
  folder.write("main.yaml", line);
  const auto verdict_with = [&](const std::string& file, const std::string& what, const std::string& by) {
    leave(folder, "main.yaml", "out");
    change(folder, "out/" + file, what, by);
    return verdict_of(folder, "out");
  };
  CHECK(verdict_with("signals.csv", "rig.x [m]", "rig.x [mm]") ==
        "signals.csv:1:1: its columns are time [s], t [s], rig.x [mm]; diagram.yaml records time [s], t [s], "
        "rig.x "
        "[m]");
  CHECK_THAT(verdict_with("signals.csv", "0.5,0.5", "0.5;0.5"), Catch::StartsWith("signals.csv:4: "));
  CHECK_THAT(verdict_with("diagram.yaml", "Gain", "Gian"), Catch::Contains("there is no block 'Gian'"));
  CHECK(verdict_with("run.json", "\"runs\"", "\"ruins\"") ==
        "run.json: does not say 'sweep' and 'runs', as every run does");
}

TEST_CASE("numbers are the same where their bits are, and nan where both are") {
  CHECK(same_bits(0.1, 0.1));
  CHECK_FALSE(same_bits(0.0, -0.0));
  CHECK_FALSE(same_bits(0.1, 0.1 + 1e-17 + 2e-17));
  CHECK(same_bits(NAN, -NAN));
  CHECK_FALSE(same_bits(NAN, INFINITY));
  CHECK(same_bits(INFINITY, INFINITY));
}

}  // namespace stepwire::replay
