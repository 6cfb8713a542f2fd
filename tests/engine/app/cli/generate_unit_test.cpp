// `generate --fmi` as its users meet it.
#include <catch2/catch.hpp>
#include <filesystem>

#include "engine/simulate/codegen/compiler.hpp"
#include "tests/engine/app/cli/program.hpp"

namespace stepwire::cli {
using Catch::Contains;

TEST_CASE("a unit is written, and what is to be known of it is said") {
  if (!codegen::Compiler().found()) return;
  const Scratch folder;
  folder.file("a.yaml",
              "stepwire: 1\ntitle: a unit\nstep: 1 ms\nstop: $until\nparameters: {k: 2, until: 1 s}\n"
              "blocks: {a: {block: UnitDelay, u: $k, every: 2 ms}}\nrecord: [a]\n");
  const Done done = run_program(folder, {"generate", "a.yaml", "--fmi", "3", "-o", "units/a.fmu"});
  INFO(done.err);
  CHECK(done.code == 0);
  CHECK_THAT(done.out, Contains("a unit of FMI 3 for co-simulation\n") &&
                           Contains("no model exchange: a works every 0.002 s") &&
                           Contains("until cannot be changed there"));
  CHECK(content_of(folder.path("units/a.fmu")).starts_with("PK"));
}

TEST_CASE("a unit that cannot be made is refused with the reason, and no file is left") {
  const Scratch folder;
  folder.file("lag.yaml", lag_yaml);
  folder.file("writes.yaml",
              "stepwire: 1\ntitle: a\nstep: 1 ms\nstop: 1 s\n"
              "blocks: {a: {block: Fmu, file: none.fmu}}\n");
  std::filesystem::create_directory(folder.path("there"));
  folder.file("file", "");
  const auto refused = [&](std::vector<std::string> more, int code, const std::string& why) {
    std::vector<std::string> call{"generate"};
    call.insert(call.end(), more.begin(), more.end());
    const Done done = run_program(folder, call);
    INFO(done.err << done.out);
    CHECK(done.code == code);
    CHECK_THAT(done.err, Contains(why));
  };
  refused({"lag.yaml", "--fmi", "4", "-o", "a.fmu"}, 2, "--fmi");
  refused({"lag.yaml", "--fmi", "3", "--c-api", "-o", "a.fmu"}, 2, "--c-api");
  refused({"lag.yaml", "--fmi", "3"}, 2, "--out");
  refused({"writes.yaml", "--fmi", "3", "-o", "a.fmu"}, 2, "none.fmu");
  refused({"lag.yaml", "--fmi", "3", "-o", "there"}, 3, "is a folder; a unit is a file");
  refused({"lag.yaml", "--fmi", "3", "-o", "file/a.fmu"}, 3, "file");
  CHECK_FALSE(std::filesystem::exists(folder.path("a.fmu")));
}

TEST_CASE("without a compiler no unit is made") {
  const Scratch folder;
  folder.file("lag.yaml", lag_yaml);
  const Done done = run_program(folder, {.arguments = {"generate", "lag.yaml", "--fmi", "3", "-o", "a.fmu"},
                                         .environment = {{"PATH", "/nowhere"}, {"CXX", {}}}});
  INFO(done.err);
  CHECK(done.code == 3);
  CHECK_THAT(done.err, Contains("no C++ compiler is there") && Contains("a unit has a binary"));
  CHECK_FALSE(std::filesystem::exists(folder.path("a.fmu")));
}

}  // namespace stepwire::cli
