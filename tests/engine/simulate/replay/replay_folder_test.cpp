#include "engine/simulate/replay/replay_folder.hpp"

#include <catch2/catch.hpp>
#include <cstdlib>
#include <set>

#include "engine/base/io/file.hpp"
#include "engine/model/diagram/flatten.hpp"
#include "tests/support/plan_text.hpp"

namespace stepwire::replay {

namespace {

const std::string head = "stepwire: 1\nstep: 1 s\nstop: 2 s\n";

std::string rows(int value) {
  return "time [s],x\n0,0\n2," + std::to_string(value) + "\n";
}

std::set<std::string> names_in(const std::string& folder) {
  std::set<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    names.insert(entry.path().filename().string());
  return names;
}

run::Job job_of(const DiagramFolder& folder, const std::string& file) {
  diagram::Loader loader(library());
  return run::make_job(loader, folder.path(file));
}

}  // namespace

TEST_CASE(
    "the flattened diagram lies beside copies of the data files, which it finds without the originals") {
  const DiagramFolder folder;
  folder.write("a/rows.csv", rows(2));
  folder.write("b/rows.csv", rows(6));
  folder.write("main.yaml", head + R"(blocks:
  one: {block: FromFile, file: a/rows.csv, column: x}
  same: {block: FromFile, file: b/../a/rows.csv, column: x}
  other: {block: FromFile, file: b/rows.csv, column: x}
record: [one, same, other]
)");
  const plan::Plan plan = folder.plan("main.yaml");
  write_replay(folder.path("out"), plan);
  CHECK(names_in(folder.path("out/inputs")) == std::set<std::string>{"rows.csv", "rows-2.csv"});
  const std::string hash = diagram::diagram_hash(plan.diagram);
  std::filesystem::remove_all(folder.path("a"));
  std::filesystem::remove_all(folder.path("b"));
  const plan::Plan kept = folder.plan("out/diagram.yaml");
  CHECK(diagram::diagram_hash(kept.diagram) == hash);
  const table::Table table = run::run_plan(kept).recordings.at(0).table;
  CHECK(table.columns.at(1).values == std::vector<double>{0, 1, 2});
  CHECK(table.columns.at(2).values == table.columns.at(1).values);
  CHECK(table.columns.at(3).values == std::vector<double>{0, 3, 6});
}

TEST_CASE("a copy has a name that a diagram file can hold") {
  const DiagramFolder folder;
  folder.write("it's 1 %, \"a\".csv", rows(8));
  folder.write("main.yaml",
               head + "blocks: {a: {block: FromFile, file: 'it''s 1 %, \"a\".csv', column: x}}\nrecord: a\n");
  write_replay(folder.path("out"), folder.plan("main.yaml"));
  CHECK(names_in(folder.path("out/inputs")) == std::set<std::string>{"it_s_1_____a_.csv"});
  CHECK(folder.run("out/diagram.yaml").columns.at(1).values.back() == 8.0);
}

TEST_CASE("data of the data folder are found beside the flattened diagram without that folder") {
  const DiagramFolder folder;
  folder.write("records/rows.csv", rows(4));
  folder.write("main.yaml",
               head + "blocks: {a: {block: FromFile, file: data/rows.csv, column: x}}\nrecord: a\n");
  const char* before = std::getenv("STEPWIRE_DATA");
  const std::string kept = before ? before : "";
  ::setenv("STEPWIRE_DATA", folder.path("records").c_str(), 1);
  write_replay(folder.path("data/out"), folder.plan("main.yaml"));
  ::unsetenv("STEPWIRE_DATA");
  std::filesystem::remove_all(folder.path("records"));
  CHECK(folder.run("data/out/diagram.yaml").columns.at(1).values.back() == 4.0);
  if (before) ::setenv("STEPWIRE_DATA", kept.c_str(), 1);
}

TEST_CASE("a sweep leaves one diagram, a row for what each run sets in it, and each data file once") {
  const DiagramFolder folder;
  folder.write("low.csv", rows(2));
  folder.write("high.csv", rows(6));
  folder.write("main.yaml", head + R"(parameters: {file: low.csv, gain: 1}
blocks: {a: {block: FromFile, file: $file, column: x}, b: {block: Gain, u: a, gain: $gain}}
record: b
sweep: {file: [low.csv, high.csv], gain: [1, 10]}
)");
  const run::Job job = job_of(folder, "main.yaml");
  write_replay(folder.path("out"), job);
  CHECK(names_in(folder.path("out")) == std::set<std::string>{"diagram.yaml", "sweep.csv", "inputs"});
  CHECK(names_in(folder.path("out/inputs")) == std::set<std::string>{"low.csv", "high.csv"});
  CHECK(io::read_file(folder.path("out/sweep.csv")) ==
        "a.file,b.gain\ninputs/low.csv,1\ninputs/low.csv,10\ninputs/high.csv,1\ninputs/high.csv,10\n");
}

TEST_CASE("runs of another structure have a diagram of their own") {
  const DiagramFolder folder;
  folder.write("main.yaml", head + R"(parameters: {gain: 1, rows: 1}
blocks: {a: {block: Constant, value: $rows}, b: {block: Gain, u: a, gain: $gain}}
record: b
sweep: {rows: [1, "= 2 + 3"], gain: [1, 10]}
)");
  const run::Job job = job_of(folder, "main.yaml");
  CHECK(job.family->size() == 1);
  folder.write("times.yaml", head + R"(parameters: {gain: 1}
blocks: {a: {block: Constant, value: 1}, b: {block: Gain, u: a, gain: $gain}}
record: b
sweep: {step: [0.5 s, 1 s], gain: [1, 10]}
)");
  write_replay(folder.path("out"), job_of(folder, "times.yaml"));
  CHECK(names_in(folder.path("out")) == std::set<std::string>{"diagrams", "sweep.csv"});
  CHECK(names_in(folder.path("out/diagrams")) == std::set<std::string>{"0001.yaml", "0002.yaml"});
  CHECK(io::read_file(folder.path("out/sweep.csv")) ==
        "diagram,b.gain\ndiagrams/0001.yaml,1\ndiagrams/0001.yaml,10\ndiagrams/0002.yaml,1\n"
        "diagrams/0002.yaml,10\n");
}

TEST_CASE("a run of what was left may be left in the same folder") {
  const DiagramFolder folder;
  folder.write("rows.csv", rows(2));
  folder.write("main.yaml", head + "blocks: {a: {block: FromFile, file: rows.csv, column: x}}\nrecord: a\n");
  write_replay(folder.path("out"), folder.plan("main.yaml"));
  const std::string before = io::read_file(folder.path("out/diagram.yaml"));
  write_replay(folder.path("out"), folder.plan("out/diagram.yaml"));
  CHECK(io::read_file(folder.path("out/diagram.yaml")) == before);
  CHECK(io::read_file(folder.path("out/inputs/rows.csv")) == rows(2));
}

TEST_CASE("a copy of a data file is no option of a program and no hidden file") {
  const DiagramFolder folder;
  for (const std::string name : {"-rf", ".rows"}) {
    folder.write(name + ".csv", rows(2));
    folder.write("main.yaml",
                 head + "blocks: {a: {block: FromFile, file: " + name + ".csv, column: x}}\nrecord: a\n");
    write_replay(folder.path("out"), folder.plan("main.yaml"));
    CHECK(io::read_file(folder.path("out/inputs/_" + name + ".csv")) == rows(2));
  }
}

TEST_CASE("a data file that is gone is a matter of the surroundings") {
  const DiagramFolder folder;
  folder.write("rows.csv", rows(2));
  folder.write("main.yaml", head + "blocks: {a: {block: FromFile, file: rows.csv, column: x}}\nrecord: a\n");
  const plan::Plan plan = folder.plan("main.yaml");
  std::filesystem::remove(folder.path("rows.csv"));
  CHECK_THROWS_AS(write_replay(folder.path("out"), plan), io::EnvironmentError);
}

}  // namespace stepwire::replay
