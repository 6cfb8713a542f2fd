// Help for newcomers from Simulink: answers to its block names, and notes on blocks whose outputs have no
// reader.
#include <catch2/catch.hpp>

#include "engine/model/diagram/simulink_names.hpp"
#include "engine/model/diagram/unread.hpp"
#include "tests/support/plan_text.hpp"
#include "tests/support/run_text.hpp"

namespace stepwire::diagram {

namespace {

std::string refusal(const std::string& type) {
  return error_of("step: 1 ms\nstop: 1 s\nblocks:\n  b: {block: \"" + type + "\"}\nrecord: [b]\n");
}

}  // namespace

TEST_CASE("a block of Simulink as a type is answered with what there is here") {
  CHECK_THAT(refusal("Scope"), Catch::Contains("there is no block 'Scope'") && Catch::Contains("`figure`"));
  CHECK_THAT(refusal("Transfer Fcn"), Catch::Contains("use TransferFunction"));
  CHECK_THAT(refusal("To Workspace"), Catch::Contains("`record`"));
  CHECK_THAT(refusal("ToWorkspace"), Catch::Contains("`record`"));
  CHECK_THAT(refusal("MATLABFunction"), Catch::Contains("Expression"));
  CHECK_THAT(refusal("RateTransition"), Catch::Contains("`every`"));
  CHECK_THAT(refusal("BusCreator"), Catch::Contains("a bus"));
  CHECK_THAT(refusal("Random Number"), Catch::Contains("use Noise"));
  CHECK(answer_to_simulink("Lag").empty());
  CHECK(answer_to_simulink("").empty());
}

TEST_CASE("a block of the file that feeds nothing and is not recorded is noted, and no other") {
  const plan::Plan plan = plan_text(
      "blocks:\n  a: {block: Clock}\n  dead: {block: Gain, u: a}\n  b: {block: Gain, "
      "u: a}\n"
      "  end: {block: Terminator, u: a}\n  stops: {block: Gain, u: a}\nrecord: [b]\nstop_when: stops > 2\n");
  const auto notes = unread_blocks(plan.diagram);
  REQUIRE(notes.size() == 1);
  CHECK_THAT(notes[0].text(), Catch::Contains("dead: feeds nothing and is not recorded"));
}

TEST_CASE("an output that is reset while off is no block of the file that feeds nothing") {
  const std::string text =
      "blocks:\n  on: {block: Clock}\n"
      "  d: {block: Demux, u: [1, 2], sizes: [1, 1], enable: {when: on, outputs: reset}}\nrecord: ";
  CHECK(unread_blocks(plan_text(text + "[d.y1]\n").diagram).empty());
  const auto notes = unread_blocks(plan_text(text + "[on]\n").diagram);
  REQUIRE(notes.size() == 1);
  CHECK_THAT(notes[0].text(), Catch::Contains("d: feeds nothing and is not recorded"));
}

TEST_CASE("a misspelt block, file or function is refused with the nearest name") {
  const std::string text =
      "step: 1 s\nstop: 1 s\nblocks:\n  spring: {block: Gain, u: t, gain: 2}\n  t: {block: Clock}\nrecord: "
      "[spring]\n";
  const auto set = faults_of(text, {{"sprng.gain", "3"}});
  REQUIRE(set.size() == 1);
  CHECK_THAT(set[0], Catch::Contains("there is no parameter 'sprng.gain'; did you mean 'spring.gain'?"));
  CHECK_THAT(error_of("step: 1 s\nstop: 1 s\nblocks:\n  t: {block: Clock}\n  e: {block: Expression, u: t, "
                      "expression: sqr(u)}\nrecord: [e]\n"),
             Catch::Contains("unknown function 'sqr'; did you mean 'sqrt'?"));
  const DiagramFolder folder;
  folder.write("road.csv", "time [s],y [m]\n0,1\n1,2\n");
  folder.write("main.yaml",
               "stepwire: 1\nstep: 1 s\nstop: 1 s\nblocks:\n  r: {block: FromFile, file: raod.csv, column: "
               "y}\nrecord: [r]\n");
  const auto file = folder.faults("main.yaml");
  REQUIRE(file.size() == 1);
  CHECK_THAT(file[0], Catch::Contains("there is no file") && Catch::Contains("did you mean") &&
                          Catch::Contains("road.csv'?"));
}

}  // namespace stepwire::diagram
