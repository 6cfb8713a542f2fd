#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "tests/engine/app/cli/program.hpp"

using Catch::Contains;

namespace {

void write_rig(const Scratch& folder) {
  std::filesystem::create_directories(folder.path("parts"));
  folder.file("rows.csv", "time [s],x [mm]\n0,1\n1,2\n");
  folder.file("parts/body.yaml",
              "stepwire: 1\nparameters: {mass: 1 kg}\ninputs: {f: {unit: N}}\noutputs: {x: m.position}\n"
              "blocks: {m: {block: Mass, force: f, mass: $mass}}\n");
  folder.file("rig.yaml",
              "stepwire: 1\ntitle: a rig\nstep: 1 ms\nstop: 0.1 s\nsolver: rk4\nparameters: {push: 2 N}\n"
              "blocks:\n  way: {block: FromFile, file: rows.csv, column: x}\n"
              "  rig: {diagram: parts/body.yaml, f: $push}\nrecord: [rig.x, way]\n");
}

std::string hash_of(const Done& run) {
  return nlohmann::json::parse(run.out)[0]["hash"];
}

}  // namespace

TEST_CASE("flatten prints one file that runs as the original does, from anywhere") {
  const Scratch folder;
  write_rig(folder);
  const Done flat = run_program(folder, {"flatten", "rig.yaml"});
  REQUIRE(flat.code == 0);
  CHECK(flat.err.empty());
  CHECK_THAT(flat.out, Contains("  rig.m: {block: Mass, force: 2 N, mass: 1 kg}\n"));
  std::filesystem::create_directories(folder.path("elsewhere"));
  folder.file("elsewhere/flat.yaml", flat.out);
  const Done one = run_program(folder, {"run", "rig.yaml", "--out", "one", "--json"});
  const Done other = run_program(folder, {"run", "elsewhere/flat.yaml", "--out", "other", "--json"});
  REQUIRE(other.code == 0);
  CHECK(content_of(folder.path("other/signals.csv")) == content_of(folder.path("one/signals.csv")));
  CHECK(hash_of(other) == hash_of(one));
  CHECK(run_program(folder, {"flatten", "elsewhere/flat.yaml"}).out == flat.out);
}

TEST_CASE("flatten -o writes a file, with what --set gives") {
  const Scratch folder;
  write_rig(folder);
  const Done done = run_program(folder, {"flatten", "rig.yaml", "--set", "rig.mass=500 g", "--set",
                                         "stop=50ms", "-o", "deep/flat.yaml"});
  REQUIRE(done.code == 0);
  CHECK(done.out.empty());
  CHECK_THAT(content_of(folder.path("deep/flat.yaml")), Contains("mass: 0.5 kg") && Contains("stop: 0.05 s"));
}

TEST_CASE("flatten refuses what run refuses, and to write over its own file") {
  const Scratch folder;
  write_rig(folder);
  folder.file("bad.yaml", "stepwire: 1\nstep: 1 s\nstop: 1 s\nblocks: {a: {block: Gian, u: 1}}\n");
  const Done bad = run_program(folder, {"flatten", "bad.yaml"});
  CHECK(bad.code == 2);
  CHECK_THAT(bad.err, Contains("bad.yaml:4:21: a: there is no block 'Gian'"));
  const std::string before = content_of(folder.path("rig.yaml"));
  const Done over = run_program(folder, {"flatten", "rig.yaml", "-o", "./rig.yaml"});
  CHECK(over.code == 2);
  CHECK_THAT(over.err, Contains("rig.yaml: would be written over by this call, which reads it"));
  for (const std::vector<std::string>& call :
       {std::vector<std::string>{"run", "rig.yaml", "--csv", "rig.yaml"},
        {"draw", "rig.yaml", "-o", "rig.yaml"},
        {"run", "rig.yaml", "--csv", "rows.csv"},
        {"generate", "rig.yaml", "--fmi", "3", "-o", "rig.yaml"}}) {
    const Done refused = run_program(folder, {call});
    INFO(call[0] << " " << call.back() << ": " << refused.err);
    CHECK(refused.code == 2);
    CHECK_THAT(refused.err, Contains(call.back() + ": would be written over by this call, which reads it"));
  }
  CHECK(content_of(folder.path("rig.yaml")) == before);
  CHECK(run_program(folder, {"flatten", "rig.yaml", "-o", "rows.csv/flat.yaml"}).code == 3);
}
