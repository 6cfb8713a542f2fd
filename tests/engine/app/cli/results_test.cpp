#include <catch2/catch.hpp>
#include <charconv>
#include <cmath>
#include <nlohmann/json.hpp>
#include <set>

#include "engine/base/mat/mat_file.hpp"
#include "engine/base/subprocess/process.hpp"
#include "engine/base/table/table_file.hpp"
#include "tests/engine/app/cli/program.hpp"

using Catch::Contains;

namespace {

std::set<std::string> names_in(const std::string& folder) {
  std::set<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    names.insert(entry.path().filename().string());
  return names;
}

std::vector<std::string> keys_of(const nlohmann::json& object) {
  std::vector<std::string> keys;
  for (const auto& [key, value] : object.items()) keys.push_back(key);
  return keys;
}

const std::string words_yaml =
    "stepwire: 1\ntitle: two ways\nstep: 1 ms\nstop: 3 ms\nparameters:\n  way: {value: linear}\nblocks:\n"
    "  table: {block: FromFile, file: rows.csv, column: x, interpolation: $way}\nrecord: [table]\n"
    "sweep: {way: {values: [hold, \"linear\"]}}\n";

}  // namespace

TEST_CASE("run --out writes all that a run leaves, and nothing else") {
  const Scratch folder;
  folder.file("lag.yaml", lag_yaml);
  const Done done = run_program(folder, {"run", "lag.yaml", "--out", "deep/out"});
  REQUIRE(done.code == 0);
  CHECK(names_in(folder.path("deep/out")) == std::set<std::string>{".stepwire", "signals.csv", "signals.mat",
                                                                   "figure.svg", "figure.json", "claims.json",
                                                                   "run.json", "diagram.yaml"});
  CHECK_THAT(content_of(folder.path("deep/out/figure.svg")), Contains("<svg") && Contains("</svg>"));
}

TEST_CASE("the spec of a picture lies beside it as JSON that other programs read") {
  const std::string python = stepwire::subprocess::find_program("python3");
  if (python.empty()) {
    WARN("python3 is not installed; no other program read the JSON");
    return;
  }
  const Scratch folder;
  folder.file("lag.yaml", lag_yaml);
  REQUIRE(run_program(folder, {"run", "lag.yaml", "--out", "out"}).code == 0);
  const std::string script =
      "import json, sys\n"
      "panel = json.load(open(sys.argv[1]))['panels'][0]\n"
      "curve = panel['marks'][0]['curves'][0]\n"
      "print(panel['x']['unit'], panel['marks'][0]['mark'], len(curve['x']) == len(curve['y']))\n";
  const auto read =
      stepwire::subprocess::run_process({.command = {python, "-c", script, folder.path("out/figure.json")}});
  CHECK(read.output == "s line True\n");
}

TEST_CASE("signals.csv and signals.mat hold the same bits, those of the closed form") {
  const Scratch folder;
  folder.file("lag.yaml", lag_yaml);
  REQUIRE(run_program(folder, {"run", "lag.yaml", "--out", "out"}).code == 0);
  const auto lines = lines_of(content_of(folder.path("out/signals.csv")));
  CHECK(lines.front() == "time [s],reference,lag");
  CHECK(lines.size() == 502);
  CHECK(lines[1] == "0,1,0");
  CHECK_THAT(lines[3], Catch::StartsWith("0.002,1,0.0198"));
  const auto csv = stepwire::table::read_csv(folder.path("out/signals.csv"));
  const auto mat = stepwire::mat::read_mat(folder.path("out/signals.mat"));
  REQUIRE(mat.find("lag") != nullptr);
  CHECK(csv.find("lag")->values == mat.find("lag")->values);
  CHECK(csv.find("time")->values == mat.find("time")->values);
  CHECK(std::abs(csv.find("lag")->values.back() - (1.0 - std::exp(-5.0))) < 1e-9);
}

TEST_CASE("claims.json and run.json have the fields that scripts read") {
  const Scratch folder;
  folder.file("lag.yaml", lag_yaml);
  REQUIRE(
      run_program(folder, {"run", "lag.yaml", "--out", "out", "--set", "tau=50ms", "--stop", "1s"}).code ==
      0);
  const nlohmann::json claims = nlohmann::json::parse(content_of(folder.path("out/claims.json")));
  REQUIRE(claims.size() == 1);
  CHECK(keys_of(claims[0]) == std::vector<std::string>{"check", "figure", "file", "holds", "that", "value"});
  CHECK(claims[0]["figure"].is_null());
  CHECK(claims[0]["holds"] == true);
  CHECK(claims[0]["check"] == "final lag >= 0.9");
  const nlohmann::json run = nlohmann::json::parse(content_of(folder.path("out/run.json")));
  CHECK(keys_of(run) == std::vector<std::string>{"algebraic_loops",
                                                 "block_folders",
                                                 "blocks",
                                                 "compiled_ticks",
                                                 "compiler",
                                                 "device",
                                                 "duration",
                                                 "events",
                                                 "faults",
                                                 "file",
                                                 "findings",
                                                 "functions",
                                                 "hash",
                                                 "interrupted",
                                                 "keep",
                                                 "kept",
                                                 "lanes",
                                                 "notices",
                                                 "parameters",
                                                 "recorded_runs",
                                                 "runs",
                                                 "solver",
                                                 "solver_steps",
                                                 "step",
                                                 "stop",
                                                 "sweep",
                                                 "ticks",
                                                 "title",
                                                 "uses",
                                                 "version"});
  CHECK(run["step"] == 0.001);
  CHECK(run["stop"] == 1.0);
  CHECK(run["solver"] == "rk4");
  CHECK(run["functions"] == "portable");
  CHECK(run["interrupted"] == false);
  CHECK(run["sweep"].is_null());
  const nlohmann::json& tau = run["parameters"][0];
  CHECK(tau["name"] == "tau");
  CHECK(tau["value"] == 0.05);
  CHECK(tau["unit"] == "s");
  CHECK(tau["set"] == true);
}

TEST_CASE("the hash changes with a parameter and not with a comment") {
  const Scratch folder;
  const auto hash_of = [&](const std::string& yaml, const std::vector<std::string>& more = {}) {
    folder.file("lag.yaml", yaml);
    std::vector<std::string> arguments{"run", "lag.yaml", "--json"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const std::string hash = nlohmann::json::parse(run_program(folder, arguments).out)[0]["hash"];
    CHECK(hash.size() == 32);
    return hash;
  };
  const std::string hash = hash_of(lag_yaml);
  CHECK(hash_of("# a comment\n" + lag_yaml) == hash);
  CHECK(hash_of(lag_yaml, {"--set", "tau=0.1000001s"}) != hash);
  CHECK(hash_of(lag_yaml, {"--stop", "0.499s"}) != hash);
  CHECK(hash_of(lag_yaml, {"--set", "tau=100ms"}) == hash);
}

TEST_CASE("with --json standard output is JSON and nothing else, whatever else is asked for") {
  const Scratch folder;
  folder.file("lag.yaml", lag_yaml);
  folder.file("bad.yaml", "stepwire: 1\n");
  for (const std::string verb : {"run", "check"}) {
    const Done done = run_program(folder, {verb, "lag.yaml", "bad.yaml", "--json", "--units"});
    CHECK(done.code == 2);
    const nlohmann::json results = nlohmann::json::parse(done.out);
    REQUIRE(results.size() == 2);
    CHECK(results[0]["file"] == "lag.yaml");
    CHECK(results[1]["file"] == "bad.yaml");
    CHECK(results[1]["faults"][0]["line"] == 1);
  }
  const Done done = run_program(folder, {"run", "lag.yaml", "--json", "--out", "out"});
  CHECK(nlohmann::json::parse(done.out)[0]["claims"][0]["holds"] == true);
}

TEST_CASE("the option --units prints the unit of every wire") {
  const Scratch folder;
  folder.file("lag.yaml", lag_yaml);
  CHECK_THAT(run_program(folder, {"check", "lag.yaml", "--units"}).out,
             Contains("  lag ") && Contains("  reference "));
}

TEST_CASE("several files get a folder each") {
  const Scratch folder;
  folder.file("a.yaml", lag_yaml);
  folder.file("b.yaml", lag_yaml);
  REQUIRE(run_program(folder, {"run", "a.yaml", "b.yaml", "--out", "out"}).code == 0);
  CHECK(names_in(folder.path("out")) == std::set<std::string>{"a", "b"});
  CHECK(names_in(folder.path("out/b")).contains("run.json"));
}

TEST_CASE("files of one name do not write over each other") {
  const Scratch folder;
  std::filesystem::create_directory(folder.path("x"));
  folder.file("a.yaml", lag_yaml);
  folder.file("x/a.yaml", lag_yaml);
  const Done done = run_program(folder, {"run", "a.yaml", "x/a.yaml", "--out", "out"});
  CHECK(done.code == 2);
  CHECK_THAT(done.err, Contains("a.yaml and x/a.yaml would both be written to out/a"));
  CHECK_FALSE(std::filesystem::exists(folder.path("out")));
  CHECK(run_program(folder, {"run", "a.yaml", "x/a.yaml"}).code == 0);
}

TEST_CASE(
    "an old result is replaced file by file, and what is not ours stays, or is refused before the run") {
  const Scratch folder;
  folder.file("lag.yaml", lag_yaml);
  std::filesystem::create_directory(folder.path("out"));
  folder.file("out/signals.csv", "mine");
  folder.file("out/notes.txt", "mine");
  const Done refused = run_program(folder, {"run", "lag.yaml", "--out", "out"});
  CHECK(refused.code == 3);
  CHECK_THAT(refused.err, Contains("out/signals.csv: there is one already that no run wrote"));
  CHECK(content_of(folder.path("out/signals.csv")) == "mine");
  std::filesystem::remove(folder.path("out/signals.csv"));
  for (int k = 0; k < 2; ++k) REQUIRE(run_program(folder, {"run", "lag.yaml", "--out", "out"}).code == 0);
  CHECK_THAT(content_of(folder.path("out/signals.csv")), Catch::StartsWith("time [s],"));
  CHECK(content_of(folder.path("out/notes.txt")) == "mine");
}

TEST_CASE("swept words stand as words in signals.csv and as their numbers in signals.mat") {
  const Scratch folder;
  folder.file("rows.csv", "time [s],x\n0,1\n1,2\n");
  folder.file("a.yaml", words_yaml);
  const Done done = run_program(folder, {"run", "a.yaml", "--out", "out"});
  INFO(done.err);
  REQUIRE(done.code == 0);
  const auto lines = lines_of(content_of(folder.path("out/signals.csv")));
  REQUIRE(lines.size() == 9);
  CHECK(lines[0] == "time [s],way,table");
  CHECK(lines[4] == "0.003,hold,1");
  CHECK(lines[8] == "0.003,linear,1.003");
  CHECK(stepwire::mat::read_mat(folder.path("out/signals.mat")).find("way")->values ==
        std::vector<double>{0, 0, 0, 0, 1, 1, 1, 1});
  const nlohmann::json run = nlohmann::json::parse(content_of(folder.path("out/run.json")));
  CHECK(run["sweep"][0]["parameter"] == "way");
  CHECK(run["sweep"][0]["values"] == nlohmann::json({"hold", "linear"}));
}

TEST_CASE("the option --set reaches into parts and blocks, and the last one counts") {
  const Scratch folder;
  folder.file("rig.yaml",
              "stepwire: 1\ntitle: rig\nparameters:\n  mass: {value: 1 kg}\ninputs:\n  force: {unit: "
              "N}\noutputs:\n  v: body.velocity\n"
              "blocks:\n  body: {block: Mass, force: force, mass: $mass}\n");
  folder.file("a.yaml",
              "stepwire: 1\ntitle: a\nstep: 1 ms\nstop: 1 s\nsolver: rk4\nblocks:\n  rig: {diagram: "
              "rig.yaml, force: 1 N}\nrecord: [rig.v]\n"
              "claims:\n  - {that: it moves, final: rig.v, equals: 0.5 m/s, within: 1e-9}\n");
  CHECK(run_program(folder, {"run", "a.yaml"}).code == 1);
  CHECK(run_program(folder, {"run", "a.yaml", "--set", "rig.mass=2kg"}).code == 0);
  CHECK(run_program(folder, {"run", "a.yaml", "--set", "rig.body.mass=2 kg"}).code == 0);
  CHECK(run_program(folder, {"run", "a.yaml", "--set", "rig.mass=7kg", "--set", "rig.mass=2000 g"}).code ==
        0);
}

TEST_CASE(
    "claims and figures may name numbers that blocks were given, by the file, a preset or as defaults") {
  const Scratch folder;
  folder.file(
      "a.yaml",
      "stepwire: 1\nstep: 10 ms\nstop: 1 s\nsolver: rk4\nblocks:\n  lag: {block: Lag, u: 1, tau: 40 ms}\n"
      "  push: {block: Step, after: 3 N, time: 250 ms}\n"
      "  damper: {block: MRDamper, preset: rd-1097-01, velocity: 10 mm/s, current: 0 A}\n"
      "record: [push, damper.force]\n"
      "figure: {plot: table, headings: [of, number], rows: {start: push.time in ms, beta: damper.beta in "
      "1/mm}}\n"
      "claims:\n"
      "  - {that: of the file, final: push.time, equals: 250 ms}\n"
      "  - {that: of a list, final: damper.current_range.2, equals: 0.35 A}\n"
      "  - {that: of the preset, final: damper.extended_length - damper.compressed_length, equals: 58 mm, "
      "within: 1e-12 m}\n"
      "  - {that: the law, where: time > 0.9 s, max: \"abs(damper.force - 1000*damper.A/(damper.beta + "
      "damper.gamma)*0.29 N/m - 0.2 N)\", at_most: 1e-3 N}\n");
  const Done done = run_program(folder, {"run", "a.yaml", "--out", "out"});
  INFO(done.out << done.err);
  CHECK(done.code == 0);
  CHECK_THAT(content_of(folder.path("out/figure.svg")), Contains(">250 ms<") && Contains(">10.61 1/mm<"));
  CHECK(run_program(folder, {"run", "a.yaml", "--set", "push.time=260ms"}).code == 1);
  folder.file("b.yaml",
              "stepwire: 1\nstep: 10 ms\nstop: 1 s\nblocks: {lag: {block: Step, time: 1 s}}\nrecord: lag\n"
              "claims: [{that: unit, final: lag.time, equals: 1 mm}]\n");
  CHECK_THAT(run_program(folder, {"run", "b.yaml"}).err, Contains("1 mm is in m"));
}

TEST_CASE("a file with a scene leaves its animation, and claims and figures see what it shows") {
  const Scratch folder;
  folder.file(
      "pen.yaml",
      "stepwire: 1\nstep: 10 ms\nstop: 1 s\nblocks: {pen: {block: Ramp, slope: [10 mm/s, 0 mm/s]}}\n"
      "record: pen\nscene:\n  view: {x: [0 mm, 10 mm], y: [-5 mm, 5 mm]}\n  objects:\n"
      "    dot: {ball: pen, color: {red: pen.1 > 5 mm, else: blue}}\n"
      "figure:\n  - {plot: scene, where: scene.dot.red == 1}\n  - {plot: lines, x: time, y: scene.dot.red}\n"
      "claims:\n  - {that: red beyond 5 mm, max: \"abs(scene.dot.red - (pen.1 > 5 mm))\", at_most: 0}\n"
      "  - {that: half of the time, fraction: scene.dot.red == 1, between: [0.49, 0.51]}\n");
  const Done done = run_program(folder, {"run", "pen.yaml", "--out", "out"});
  INFO(done.out << done.err);
  REQUIRE(done.code == 0);
  CHECK_THAT(content_of(folder.path("out/scene.svg")), Contains("<animate attributeName=\"cx\""));
  CHECK_THAT(content_of(folder.path("out/figure.svg")), Contains("fill=\"#ff3b30\""));
  CHECK(lines_of(content_of(folder.path("out/signals.csv"))).front() == "time [s],pen.1 [m],pen.2 [m]");
  CHECK(run_program(folder, {"verify", "out"}).code == 0);
}

TEST_CASE("what is wrong in a scene is told before the first step") {
  const Scratch folder;
  folder.file("pen.yaml",
              "stepwire: 1\nstep: 10 ms\nstop: 1 s\nblocks: {pen: {block: Constant, value: [1 mm, 2 mm]}}\n"
              "record: pen\nscene: {view: {x: [0 mm, 10 mm], y: [0, 1 mm]}, objects: {dot: {ball: pne}},\n"
              "  animation: {to: 2 s}}\nfigure: {plot: scene, at: 3 s}\n");
  const Done done = run_program(folder, {"check", "pen.yaml"});
  CHECK(done.code == 2);
  CHECK_THAT(done.err, Contains("pen.yaml:6:71: scene.dot.ball: 'pne' is not recorded; did you mean 'pen'?"));
  CHECK_THAT(done.err, Contains("scene.animation.to: 2 s is not within the run, which lasts 1 s"));
  CHECK_THAT(done.err, Contains("figure.at: 3 s is not within the run, which lasts 1 s"));
}

TEST_CASE("swept words with quotes and backslashes are those of the file") {
  const Scratch folder;
  folder.file("a\"b.csv", "time,x\n0,1\n1,1\n");
  folder.file("a\\nb.csv", "time,x\n0,2\n1,2\n");
  folder.file("c.csv", "time,x\n0,3\n1,3\n");
  folder.file("m.yaml",
              "stepwire: 1\ntitle: words\nstep: 1 s\nstop: 1 s\nparameters: {w: {value: c.csv, doc: file}}\n"
              "sweep: {w: ['a\"b.csv', 'a\\nb.csv']}\nblocks:\n  x: {block: FromFile, file: $w, column: x}\n"
              "record: [x]\nclaims:\n  - {that: the first, min: x, equals: 1}\n"
              "  - {that: both, max: x, equals: 2}\n");
  const auto run = run_program(folder, {"run", "m.yaml", "--csv", "-"});
  INFO(run.err);
  CHECK_THAT(run.out, Contains("a\"\"b.csv") || Contains("a\"b.csv"));
  CHECK_THAT(run.out, Contains("a\\nb.csv"));
  CHECK_THAT(run.err + run.out, Contains("ok   both"));
}
