#include <catch2/catch.hpp>

#include "engine/base/json/json.hpp"
#include "tests/engine/app/cli/program.hpp"

namespace {

/// A file with units below the names, a gap and rows out of order, and a plain one.
void write_files(const Scratch& folder) {
  folder.file("a.csv", "t;x;y\ns;mm;N\n0,5;1;2\n0;0;\n");
  folder.file("b.csv", "time,z\n0,1\n1,2\n");
}

}  // namespace

TEST_CASE("check prints one line for each data file: how it was read, and what was done to its rows") {
  const Scratch folder;
  write_files(folder);
  folder.file("a.yaml",
              "stepwire: 1\ntitle: records\nstep: 0.1 s\nstop: 0.4 s\nblocks:\n"
              "  x: {block: FromFile, file: a.csv, column: x, sort: true}\n"
              "  z: {block: FromFile, file: b.csv, column: z}\nrecord: [x, z]\n");
  const Done done = run_program(folder, {"check", "a.yaml"});
  INFO(done.err);
  REQUIRE(done.code == 0);
  CHECK(lines_of(done.out) ==
        std::vector<std::string>{"a.yaml: 2 blocks, 0 claims, 0 figures: nothing wrong",
                                 "  a.csv: separator ';', decimal comma, units in line 2, rows sorted by 't'",
                                 "  b.csv: separator ',', decimal point"});
  const Done as_json = run_program(folder, {"check", "--json", "a.yaml"});
  const auto files = *stepwire::json::Json::parse(as_json.out).items().front().find("data_files");
  REQUIRE(files.items().size() == 2);
  CHECK(files.items().front().find("file")->text() == "\"a.csv\"");
  CHECK(files.items().front().find("done")->items().size() == 4);
}

TEST_CASE("check --strict counts the notes that make its exit code 1") {
  const Scratch folder;
  folder.file("a.yaml",
              "stepwire: 1\ntitle: unread\nstep: 0.1 s\nstop: 0.4 s\nblocks:\n"
              "  x: {block: Constant, value: 1}\n  y: {block: Gain, u: x, gain: 2}\n"
              "  z: {block: Constant, value: 1}\nrecord: [z]\n");
  const Done strict = run_program(folder, {"check", "a.yaml", "--strict"});
  CHECK(strict.code == 1);
  CHECK(strict.out == "a.yaml: 3 blocks, 0 claims, 0 figures: 1 note\n");
  CHECK_THAT(run_program(folder, {"check", "a.yaml"}).out, Catch::Contains("nothing wrong"));
}

TEST_CASE("a file that is refused leaves no line behind for the next one") {
  const Scratch folder;
  write_files(folder);
  folder.file("bad.yaml",
              "stepwire: 1\ntitle: bad\nstep: 0.1 s\nstop: 0.4 s\nblocks:\n"
              "  y: {block: FromFile, file: a.csv, column: y, sort: true}\nrecord: [y]\n");
  folder.file("good.yaml",
              "stepwire: 1\ntitle: good\nstep: 0.1 s\nstop: 0.4 s\nblocks:\n"
              "  z: {block: FromFile, file: b.csv, column: z}\nrecord: [z]\n");
  const Done done = run_program(folder, {"check", "bad.yaml", "good.yaml"});
  CHECK(done.code == 2);
  CHECK_THAT(done.err, Catch::Contains("a.csv:4: y has no value; say `missing: hold`"));
  CHECK_THAT(done.out, !Catch::Contains("a.csv") && Catch::Contains("  b.csv: separator ','"));
}

TEST_CASE("a file among several that has no key of a diagram is left out with a note") {
  const Scratch folder;
  folder.file("lag.yaml", lag_yaml);
  folder.file("accepted.yaml", "baseline: baseline.csv\nsignals:\n  \"*\": {relative: 1 %}\n");
  for (const std::string verb : {"check", "run"}) {
    const Done done = run_program(folder, {verb, "accepted.yaml", "lag.yaml"});
    INFO(done.out << done.err);
    CHECK(done.code == 0);
    CHECK(done.err == "note: accepted.yaml: is left out; it has no key of a diagram\n");
    CHECK_THAT(done.out, Catch::Contains("lag.yaml: "));
    CHECK(run_program(folder, {verb, "accepted.yaml"}).code == 2);
  }
  CHECK_THAT(run_program(folder, {"report", "."}).out, Catch::Contains("report.html: 1 of 1 diagram"));
}
