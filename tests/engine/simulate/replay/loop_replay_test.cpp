// Folders of loops, written by hand: what they hold was computed by hand.
#include <catch2/catch.hpp>
#include <filesystem>

#include "tests/engine/simulate/replay/left_folder.hpp"

namespace stepwire::replay {

namespace {

const std::string diagram = R"(stepwire: 1
step: 0.5 s
stop: 1 s
inputs: {pair: {default: [10, 20]}, push: {unit: N, default: 1}}
outputs: {total: {signal: total, safe: 0}}
blocks:
  total: {block: Sum, u: [push, late]}
  late: {block: UnitDelay, u: total}
  both: {block: Gain, u: pair, gain: 2}
record: [total, both]
)";

/// Recorded signals. The total adds up the pushes: 1, 1, then 5 from tick 2 on, and 0 from tick 4 on. The
/// rows of ticks 2, 4 and 5 are lost.
const std::string signals =
    "time [s],tick,wall [s],total [N],both.1,both.2\n"
    "0,0,0.1,1,20,40\n0.5,1,0.7,2,20,40\n1.5,3,1.6,12,2,4\n3,6,3.1,12,2,4\n";
const std::string inputs = "time [s],tick,pair.1,pair.2,push [N]\n1,2,1,2,5\n2,4,1,2,0\n";

struct LoopFolder : DiagramFolder {
  LoopFolder() {
    write("out/diagram.yaml", diagram);
    write("out/signals.csv", signals);
    write("out/inputs.csv", inputs);
    write("out/loop.json", "{}");
  }
  std::string verdict_with(const std::string& file, const std::string& what, const std::string& by) {
    write("out/signals.csv", signals);
    write("out/inputs.csv", inputs);
    change(*this, "out/" + file, what, by);
    return verdict_of(*this, "out");
  }
};

}  // namespace

TEST_CASE("a loop is replayed with its inputs, beyond the stop of its file and over rows that were lost") {
  LoopFolder folder;
  CHECK(verdict_of(folder, "out") == "3 signals in 4 rows: all bits agree; 3 rows are lost");
}

TEST_CASE("rows that a full disk has refused are told, and a loop without an end") {
  LoopFolder folder;
  folder.write("out/loop.json", R"({"rows": {"written": 4, "lost_to_disk": 7}})");
  CHECK(verdict_of(folder, "out") ==
        "3 signals in 3 rows: all bits agree; 1 row is lost; the inputs of 1 row are missing in inputs.csv, "
        "and "
        "it is not compared; the disk refused 7 rows after these");
  std::filesystem::remove(folder.path("out/loop.json"));
  CHECK_THAT(verdict_of(folder, "out"), Catch::Contains("; there is no loop.json: the loop has not come to "
                                                        "its end or its disk was full"));
}

TEST_CASE("rows of a loop without an end are compared up to its last input, and the others are counted") {
  LoopFolder folder;
  std::filesystem::remove(folder.path("out/loop.json"));
  CHECK_THAT(folder.verdict_with("signals.csv", "3,6,3.1,12", "3,6,3.1,15"),
             Catch::StartsWith("3 signals in 3 rows: all bits agree; 1 row is lost; the inputs of 1 row are "
                               "missing in inputs.csv, and it is not compared; there is no loop.json"));
  CHECK(folder.verdict_with("signals.csv", "1.6,12", "1.6,13") ==
        "signals.csv:4: total at 1.5 s is 13 and 12 when it is replayed");
  folder.write("out/inputs.csv", "time [s],tick,pair.1,pair.2,push [N]\n");
  folder.write("out/signals.csv", signals);
  CHECK_THAT(verdict_of(folder, "out"),
             Catch::StartsWith("3 signals in 0 rows: nothing is compared; the inputs of 4 rows are missing"));
  folder.write("out/loop.json", R"({"rows": {"written": 4, "lost_to_disk": 7}})");
  folder.write("out/inputs.csv", inputs);
  CHECK_THAT(folder.verdict_with("signals.csv", "3,6,3.1,12", "3,6,3.1,15"),
             Catch::Contains("the inputs of 1 row are missing in inputs.csv"));
}

TEST_CASE("a number of a loop that differs is named") {
  LoopFolder folder;
  CHECK(folder.verdict_with("signals.csv", "3.1,12", "3.1,13") ==
        "signals.csv:5: total at 3 s is 13 and 12 when it is replayed");
  CHECK(folder.verdict_with("signals.csv", "3,6,", "3.5,6,") ==
        "signals.csv:5: time at 3 s is 3.5 and 3 when it is replayed");
  CHECK(folder.verdict_with("inputs.csv", "1,2,5", "1,2,6") ==
        "signals.csv:4: total at 1.5 s is 12 and 14 when it is replayed");
  CHECK(folder.verdict_with("signals.csv", "0,0,0.1,", "0,0,9,") ==
        "3 signals in 4 rows: all bits agree; 3 rows are lost");
}

TEST_CASE("an input of tick 0 counts from the start, and inputs may be as they were all the time") {
  LoopFolder folder;
  folder.write("out/inputs.csv", "time [s],tick,pair.1,pair.2,push [N]\n0,0,1,2,4\n");
  folder.write("out/signals.csv",
               "time [s],tick,wall [s],total [N],both.1,both.2\n0,0,0,4,2,4\n0.5,1,0,8,2,4\n");
  CHECK(verdict_of(folder, "out") == "3 signals in 2 rows: all bits agree");
  folder.write("out/inputs.csv", "time [s],tick,pair.1,pair.2,push [N]\n");
  folder.write("out/signals.csv", "time [s],tick,wall [s],total [N],both.1,both.2\n0.5,1,0,2,20,40\n");
  CHECK(verdict_of(folder, "out") == "3 signals in 1 row: all bits agree; 1 row is lost");
}

TEST_CASE("what is not finite ends the replay as it ended the loop") {
  LoopFolder folder;
  CHECK(folder.verdict_with("inputs.csv", "1,2,1,2,5", "1.5,3,1,2,nan") ==
        "signals.csv:4: total at 1.5 s is 12 and nan when it is replayed");
  folder.write("out/signals.csv", "time [s],tick,wall [s],total [N],both.1,both.2\n1.5,3,0,nan,2,4\n");
  CHECK(verdict_of(folder, "out") == "3 signals in 1 row: all bits agree; 3 rows are lost");
  folder.write("out/signals.csv",
               "time [s],tick,wall [s],total [N],both.1,both.2\n1.5,3,0,nan,2,4\n2,4,0,nan,2,4\n");
  CHECK(verdict_of(folder, "out") == "signals.csv:3: there is a row at 2 s, but the replay ends at 1.5 s");
}

TEST_CASE("a loop's folder that is damaged is refused where it is") {
  LoopFolder folder;
  CHECK(folder.verdict_with("signals.csv", "1.5,3,", "1.5,1,") ==
        "signals.csv:4:1: tick 1 is no whole number above that of the row before");
  CHECK(folder.verdict_with("inputs.csv", "2,4,", "2,4.5,") ==
        "inputs.csv:3:1: tick 4.5 is no whole number above that of the row before");
  CHECK(
      folder.verdict_with("inputs.csv", "pair.2", "pear") ==
      "inputs.csv:1:1: its columns are time, tick, pair.1, pear, push; the inputs of diagram.yaml make time, "
      "tick, pair.1, pair.2, push");
  CHECK_THAT(folder.verdict_with("signals.csv", "total [N]", "sum [N]"),
             Catch::StartsWith("signals.csv:1:1: its columns are time [s], tick, wall [s], sum [N]"));
  std::filesystem::remove(folder.path("out/inputs.csv"));
  folder.write("out/signals.csv", signals);
  CHECK_THAT(verdict_of(folder, "out"), Catch::StartsWith("inputs.csv: is missing"));
  std::filesystem::remove(folder.path("out/diagram.yaml"));
  CHECK_THAT(verdict_of(folder, "out"), Catch::StartsWith("diagram.yaml: is missing"));
}

TEST_CASE(
    "a run whose signals are called tick and wall is no loop, and a loop after a run in one folder is one") {
  const DiagramFolder folder;
  folder.write("main.yaml",
               "stepwire: 1\nstep: 1 s\nstop: 2 s\nblocks:\n  tick: {block: Clock}\n  wall: {block: Clock}\n"
               "record: [tick, wall]\n");
  leave(folder, "main.yaml", "out");
  CHECK(verdict_of(folder, "out") == "2 signals in 3 rows: all bits agree");
  folder.write("out/diagram.yaml", diagram);
  folder.write("out/signals.csv", signals);
  folder.write("out/inputs.csv", inputs);
  folder.write("out/loop.json", "{}");
  CHECK(verdict_of(folder, "out") == "3 signals in 4 rows: all bits agree; 3 rows are lost");
}

}  // namespace stepwire::replay
