// A folder given to --out belongs to one run.
#include <catch2/catch.hpp>
#include <filesystem>
#include <thread>

#include "engine/base/io/owned_folder.hpp"
#include "tests/engine/app/cli/program.hpp"
#include "tests/engine/app/cli/small_study.hpp"

using Catch::Contains;

namespace {

bool there(const Scratch& folder, const std::string& name) {
  return std::filesystem::exists(folder.path(name));
}

}  // namespace

TEST_CASE("a folder that another run writes into is refused with 3, by every verb that writes one") {
  const Scratch folder;
  folder.file("lag.yaml", lag_yaml);
  const stepwire::io::OwnedFolder own(folder.path("out"));
  stepwire::io::note_written(folder.path("out/figure.svg"));
  folder.file("out/figure.svg", "of the other run");
  for (const std::vector<std::string>& call : {std::vector<std::string>{"run", "lag.yaml", "--out", "out"},
                                               {"loop", "lag.yaml", "--duration", "0.1", "--out", "out"},
                                               {"thesis", "--only", "fig31", "--out", "out"}}) {
    const Done done = run_program(folder, call);
    INFO(done.err);
    CHECK(done.code == 3);
    CHECK(lines_of(done.err).size() == 1);
    CHECK_THAT(done.err, Contains("out: another run is writing into this folder"));
    CHECK(content_of(folder.path("out/figure.svg")) == "of the other run");
  }
}

TEST_CASE("what an older run left is not taken for the new one's, and a file of one's own stays") {
  const Scratch folder;
  folder.file("two.yaml",
              lag_yaml + "scene: {view: {x: [-1, 1], y: [-1, 1]}, objects: {ball: {ball: [lag, lag]}}}\n");
  folder.file("lag.yaml", lag_yaml);
  std::filesystem::create_directory(folder.path("out"));
  folder.file("out/notes.txt", "mine");
  folder.file("out/figure-2.svg", "mine, too");
  CHECK(run_program(folder, {"run", "two.yaml", "--profile", "--out", "out"}).code == 0);
  REQUIRE(there(folder, "out/profile.csv"));
  REQUIRE(there(folder, "out/scene.svg"));
  folder.file("out/signals.mat.4711-3.part", "half");
  CHECK(run_program(folder, {"run", "lag.yaml", "--out", "out"}).code == 0);
  CHECK_FALSE(there(folder, "out/profile.csv"));
  CHECK_FALSE(there(folder, "out/scene.svg"));
  CHECK_FALSE(there(folder, "out/signals.mat.4711-3.part"));
  CHECK(there(folder, "out/signals.csv"));
  CHECK(content_of(folder.path("out/notes.txt")) == "mine");
  CHECK(content_of(folder.path("out/figure-2.svg")) == "mine, too");
  CHECK(run_program(folder, {"verify", "out"}).code == 0);
}

TEST_CASE("a diagram that lies in the folder of its own results is run into it") {
  const Scratch folder;
  folder.file("lag.yaml", lag_yaml);
  CHECK(run_program(folder, {"run", "lag.yaml", "--out", "out"}).code == 0);
  for (int again = 0; again < 2; ++again) {
    const Done done = run_program(folder, {"run", "out/diagram.yaml", "--out", "out"});
    INFO(done.err);
    CHECK(done.code == 0);
    CHECK(there(folder, "out/diagram.yaml"));
  }
}

TEST_CASE("a file that is wrong leaves the older results alone") {
  const Scratch folder;
  folder.file("lag.yaml", lag_yaml);
  CHECK(run_program(folder, {"run", "lag.yaml", "--out", "out"}).code == 0);
  folder.file("lag.yaml", "stepwire: 1\n");
  CHECK(run_program(folder, {"run", "lag.yaml", "--out", "out"}).code == 2);
  CHECK(there(folder, "out/figure.svg"));
}
