#include <catch2/catch.hpp>
#include <filesystem>
#include <string>
#include <vector>

#include "tests/engine/app/cli/program.hpp"

using Catch::Contains;
using Catch::StartsWith;

namespace {

void write_rig(const Scratch& folder) {
  folder.file(
      "part.yaml",
      "stepwire: 1\ninputs: {u: {}}\noutputs: {y: half}\nblocks: {half: {block: Gain, gain: 0.5, u: u}}\n");
  folder.file("rig.yaml",
              "stepwire: 1\ntitle: a rig\nstep: 1 ms\nstop: 0.1 s\n"
              "blocks: {in: {block: Sine}, rig: {diagram: part.yaml, u: in}}\nrecord: rig\n");
}

}  // namespace

TEST_CASE("draw prints a picture, or writes it, the same bytes each time") {
  const Scratch folder;
  write_rig(folder);
  const Done done = run_program(folder, {"draw", "rig.yaml"});
  REQUIRE(done.code == 0);
  CHECK(done.err.empty());
  CHECK_THAT(done.out, StartsWith("<svg ") && Contains("<title>a rig</title>") && Contains(">rig</text>"));
  REQUIRE(run_program(folder, {"draw", "rig.yaml", "-o", "deep/rig.svg"}).code == 0);
  CHECK(content_of(folder.path("deep/rig.svg")) == done.out);
}

TEST_CASE("draw opens the parts that are named, down to a depth, and draws a part alone") {
  const Scratch folder;
  write_rig(folder);
  CHECK_THAT(run_program(folder, {"draw", "rig.yaml"}).out, !Contains(">half</text>"));
  const Done named = run_program(folder, {"draw", "rig.yaml", "--open", "rig"});
  CHECK_THAT(named.out, Contains(">half</text>"));
  CHECK(run_program(folder, {"draw", "rig.yaml", "--depth", "1"}).out == named.out);
  CHECK_THAT(run_program(folder, {"draw", "part.yaml"}).out, Contains(">half</text>"));
}

TEST_CASE("draw refuses what run refuses, and parts that are not there") {
  const Scratch folder;
  write_rig(folder);
  folder.file("bad.yaml", "stepwire: 1\nstep: 1 s\nstop: 1 s\nblocks: {a: {block: Gian, u: 1}}\n");
  const Done bad = run_program(folder, {"draw", "bad.yaml"});
  CHECK(bad.code == 2);
  CHECK_THAT(bad.err, StartsWith("bad.yaml:4:21: a: there is no block 'Gian'; did you mean 'Gain'?"));
  const Done unknown = run_program(folder, {"draw", "rig.yaml", "--open", "rgi"});
  CHECK(unknown.code == 2);
  CHECK(unknown.err == "rig.yaml: there is no part 'rgi'; did you mean 'rig'? It has: rig\n");
}

TEST_CASE("draw says in one line with 3 that node is missing") {
  const Scratch folder;
  write_rig(folder);
  Call call;
  call.arguments = {"draw", "rig.yaml"};
  call.environment["PATH"] = folder.path("");
  const Done done = run_program(folder, call);
  CHECK(done.code == 3);
  CHECK(done.err == "node is not installed; on Debian it is the package nodejs\n");
}

TEST_CASE("a drawing of more blocks than can be laid out is refused, and fewer parts of it are drawn") {
  const Scratch folder;
  for (int i = 0; i < 12; ++i) {
    const std::string next = "{diagram: part" + std::to_string(i + 1) + ".yaml}";
    folder.file(
        "part" + std::to_string(i) + ".yaml",
        "stepwire: 1\nstep: 1 s\nstop: 1 s\noutputs: {y: a.y}\nblocks: {a: " + next + ", b: " + next + "}\n");
  }
  folder.file("part12.yaml", "stepwire: 1\noutputs: {y: c}\nblocks: {c: {block: Constant, value: 1}}\n");
  const Done refused = run_program(folder, {"draw", "part0.yaml", "--depth", "32"});
  CHECK(refused.code == 2);
  CHECK_THAT(refused.err, Contains("part0.yaml: more than 2000 blocks would be drawn; open fewer parts"));
  CHECK(run_program(folder, {"draw", "part0.yaml", "--depth", "2"}).code == 0);
}

TEST_CASE("a picture with the ending of another format is refused by draw, diff and compare") {
  const Scratch folder;
  write_rig(folder);
  folder.file("a.csv", "time [s],x\n0,1\n1,2\n");
  using Words = std::vector<std::string>;
  for (const Words& words :
       {Words{"draw", "rig.yaml"}, {"diff", "rig.yaml", "part.yaml"}, {"compare", "a.csv", "a.csv"}}) {
    Call call;
    call.arguments = words;
    call.arguments.insert(call.arguments.end(), {"-o", "rig.gif"});
    const Done done = run_program(folder, call);
    CHECK(done.code == 2);
    CHECK_THAT(done.err, Contains("rig.gif: a picture is a .svg, .png or .pdf file, not '.gif'"));
    CHECK(!std::filesystem::exists(folder.path("rig.gif")));
  }
}
