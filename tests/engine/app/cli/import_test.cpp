// The verb import: its report, its files and its exit codes.
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "tests/engine/app/cli/program.hpp"
#include "tests/engine/app/simulink/slx.hpp"

using Catch::Contains;
using stepwire::simulink::block;
using stepwire::simulink::entries_of;
using stepwire::simulink::line;
using stepwire::simulink::number;

namespace {

std::string model(const Scratch& folder, const std::string& name, const std::string& type) {
  const std::string system = number(1, "3") + block(type, "Block", 2) + block("Scope", "Scope", 3) +
                             line("1#out:1", {"2#in:1"}) + line("2#out:1", {"3#in:1"});
  return stepwire::testing::write_zip(folder.path(name), entries_of({system}));
}

}  // namespace

TEST_CASE("import writes a diagram that check and run take") {
  const Scratch folder;
  model(folder, "tank.slx", "Gain");
  const Done imported = run_program(folder, {"import", "tank.slx"});
  CHECK(imported.code == 0);
  CHECK_THAT(imported.out,
             Contains("tank.slx: 3 of 3 blocks translated") && Contains("written to tank.yaml"));
  CHECK(run_program(folder, {"check", "tank.yaml"}).code == 0);
  CHECK(run_program(folder, {"run", "tank.yaml"}).code == 0);
  const Done again = run_program(folder, {"import", "tank.slx"});
  CHECK(again.code == 2);
  CHECK_THAT(again.err, Contains("tank.yaml: is there already; name the file to write with -o"));
  CHECK(run_program(folder, {"import", "tank.slx", "-o", "tank.yaml"}).code == 0);
}

TEST_CASE("import reports a placeholder with exit code 1, and run refuses it") {
  const Scratch folder;
  model(folder, "a.slx", "S-Function");
  const Done imported = run_program(folder, {"import", "a.slx", "-o", "b.yaml", "--json"});
  CHECK(imported.code == 1);
  const auto report = nlohmann::json::parse(imported.out);
  CHECK(report["files"] == nlohmann::json{"b.yaml", "b-parts/Block.yaml"});
  CHECK(report["finished"] == false);
  CHECK(report["translated"] == 2);
  CHECK(report["notes"][0]["kind"] == "placeholder");
  CHECK(run_program(folder, {"check", "b.yaml"}).code == 0);
  const Done run = run_program(folder, {"run", "b.yaml"});
  CHECK(run.code == 2);
  CHECK_THAT(run.err, Contains("write_the_blocks_of_Block_here"));
}

TEST_CASE("import refuses other files with one sentence") {
  const Scratch folder;
  folder.file("a.slx", "text");
  const Done broken = run_program(folder, {"import", "a.slx", "--json"});
  CHECK(broken.code == 2);
  CHECK_THAT(broken.err, Contains("a Simulink model is a zip archive"));
  CHECK(nlohmann::json::parse(broken.out)["faults"].size() == 1);
  CHECK(run_program(folder, {"import", "none.slx"}).code == 2);
  CHECK(run_program(folder, {"import"}).code == 2);
  CHECK_THAT(run_program(folder, {"import", "--table"}).out, Contains("| Integrator | `Integrator`"));
}
