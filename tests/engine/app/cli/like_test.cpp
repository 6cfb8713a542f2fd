// The claim `like` with a baseline of each kind of file.
#include <catch2/catch.hpp>
#include <filesystem>

#include "tests/engine/app/cli/program.hpp"

using Catch::Contains;

namespace {

std::string ramp_like(const std::string& baseline, const std::string& slope) {
  return "stepwire: 1\nstep: 0.1 s\nstop: 1 s\nblocks:\n  x: {block: Ramp, slope: " + slope +
         "}\nrecord: [x]\n" +
         (baseline.empty() ? "" : "claims:\n  - {that: as before, like: " + baseline + ", within: 1 %}\n");
}

}  // namespace

TEST_CASE("a claim is like a baseline in each kind of file, and like the folder of a run") {
  const Scratch folder;
  folder.file("first.yaml", ramp_like("", "2 m/s"));
  REQUIRE(run_program(folder, {"run", "first.yaml", "--out", "out", "--files", "csv,mat,h5,mcap"}).code == 0);
  for (const std::string baseline :
       {"out/signals.csv", "out/signals.mat", "out/signals.h5", "out/signals.mcap", "out"}) {
    INFO(baseline);
    folder.file("same.yaml", ramp_like(baseline, "2.01 m/s"));
    const Done same = run_program(folder, {"run", "same.yaml"});
    INFO(same.out << same.err);
    CHECK(same.code == 0);
    folder.file("other.yaml", ramp_like(baseline, "2.03 m/s"));
    CHECK(run_program(folder, {"run", "other.yaml"}).code == 1);
  }
}

TEST_CASE("a symbolic link to itself is a bad file for each verb") {
  const Scratch folder;
  folder.file("first.yaml", ramp_like("", "2 m/s"));
  for (const char* name : {"loop.yaml", "loop.csv"}) std::filesystem::create_symlink(name, folder.path(name));
  folder.file("x.csv", "time,x\n0,1\n");
  for (const std::vector<std::string>& call : {std::vector<std::string>{"check", "loop.yaml"},
                                               {"compare", "loop.csv", "x.csv"},
                                               {"compare", "x.csv", "loop.csv"},
                                               {"diff", "loop.yaml", "first.yaml"},
                                               {"report", "loop.yaml"},
                                               {"diff", "--text", "loop.yaml"},
                                               {"merge", "first.yaml", "loop.yaml", "first.yaml"},
                                               {"statistics", "loop.csv"},
                                               {"statistics", "/dev/full"},
                                               {"compare", "/dev/full", "x.csv"},
                                               {"blocks", "loop.yaml"},
                                               {"diff", "--text", "/dev/full"}}) {
    INFO(call[0] << " " << call[1]);
    CHECK(run_program(folder, call).code == 2);
  }
}
