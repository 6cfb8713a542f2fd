#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "engine/table/file.hpp"
#include "tests/engine/cli/program.hpp"

using Catch::Contains;

namespace {

Done interrupted(const Scratch& folder, const std::vector<std::string>& arguments) {
  Call call;
  call.arguments = arguments;
  call.interrupt_after = 0.5;
  return run_program(folder, call);
}

}  // namespace

TEST_CASE("an interrupted run ends with 130 and keeps what was recorded") {
  const Scratch folder;
  folder.file(
      "endless.yaml",
      endless_yaml +
          "figure: {plot: lines, x: time, y: lag}\nclaims:\n  - {that: it swings, max: lag, at_least: 0}\n");
  const Done done = interrupted(folder, {"run", "endless.yaml", "--out", "out"});
  INFO(done.err);
  CHECK(done.code == 130);
  const auto table = stepwire::read_table(folder.path("out/signals.csv"));
  CHECK(table.rows() > 1);
  CHECK(table.rows() < 100'000);
  CHECK(stepwire::read_table(folder.path("out/signals.mat")).find("lag")->values ==
        table.find("lag")->values);
  const auto run = nlohmann::json::parse(content_of(folder.path("out/run.json")));
  CHECK(run["interrupted"] == true);
  CHECK(run["ticks"] > 0);
  CHECK(nlohmann::json::parse(content_of(folder.path("out/claims.json")))[0]["holds"] == false);
  for (const auto& entry : std::filesystem::directory_iterator(folder.path("out"))) {
    CHECK(entry.path().extension() != ".part");
    CHECK(entry.path().extension() != ".svg");
  }
}

TEST_CASE("an interrupted sweep keeps the runs that were begun, and files that wait are left") {
  const Scratch folder;
  folder.file("a.yaml", endless_yaml + "sweep: {lag.tau: {from: 0.1 s, to: 0.2 s, count: 20}}\n");
  folder.file("b.yaml", lag_yaml);
  const Done done = interrupted(folder, {"run", "a.yaml", "b.yaml", "--out", "out"});
  INFO(done.err);
  CHECK(done.code == 130);
  CHECK(stepwire::read_table(folder.path("out/a/signals.csv")).rows() > 1);
  CHECK_FALSE(std::filesystem::exists(folder.path("out/b")));
}
