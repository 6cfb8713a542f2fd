#include <catch2/catch.hpp>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "engine/base/subprocess/process.hpp"
#include "engine/simulate/codegen/compiler.hpp"
#include "tests/engine/app/cli/program.hpp"

namespace stepwire::cli {
using Catch::Contains;

namespace {

/// With all that a program has of its own: an input, outputs, vectors, two periods, noise, an end before its
/// time.
const std::string rig_yaml = R"(stepwire: 1
title: a rig
step: 1 ms
stop: 2 s
solver: rk4
stop_when: fast > 0.5 && time > 0.2
inputs: {force: {unit: N, default: [3 N, 4 N], doc: of the hand}}
outputs: {current: {signal: held, safe: 0}}
blocks:
  noise:  {block: Noise, seed: 3, deviation: 0.1, every: 5 ms}
  push:   {block: Sum, u: [force, wave]}
  wave:   {block: Sine, frequency: 2, amplitude: [1 N, 2 N]}
  fast:   {block: Lag, tau: 0.3, u: noise, initial: -1}
  slow:   {block: Integrator, u: push, initial: [1, -1]}
  held:   {block: ZeroOrderHold, u: fast, every: 10 ms}
  shape:  {block: Expression, expression: "u1 > 0 ? u1^2 : -u1", u: [fast]}
record:
  - {every: 2 ms, signals: [slow, shape]}
  - {every: 10 ms, signals: [held, force]}
)";

/// Where the compilers' standard streams and search path are those of this machine.
bool there_is_a_compiler() {
  if (codegen::Compiler().found()) return true;
  WARN("there is no C++ compiler here; nothing was compared");
  return false;
}

/// The command that `generate` prints for its folder; it names Ninja, since make is not on every machine.
std::string build_command(const std::string& printed) {
  const std::size_t begin = printed.find("cmake -S "), end = printed.find(" makes a program");
  REQUIRE(begin < end);
  REQUIRE(end != std::string::npos);
  const std::string command = printed.substr(begin, end - begin);
  CHECK_THAT(command, Contains(" -G Ninja "));
  return command;
}

}  // namespace

TEST_CASE("a generated program is built without us and writes the same bytes as a run, or none", "[full]") {
  if (!there_is_a_compiler()) return;
  const std::string solver = GENERATE(as<std::string>(), "rk4", "rosenbrock", "sdirk");
  CAPTURE(solver);
  const Scratch folder;
  std::string yaml = rig_yaml;
  yaml.replace(yaml.find("rk4"), 3, solver);
  folder.file("rig.yaml", yaml);
  REQUIRE(run_program(folder, {"run", "rig.yaml", "--out", "out"}).code == 0);
  const Done done = run_program(folder, {"generate", "rig.yaml", "-o", "rig"});
  INFO(done.err);
  REQUIRE(done.code == 0);
  const std::string made = folder.path("rig");
  const subprocess::ProcessResult built = subprocess::run_process(
      {.command = {"sh", "-c", "cd '" + folder.path("") + "' && " + build_command(done.out)},
       .limit = subprocess::compiler_limit()});
  INFO(built.output << built.errors);
  REQUIRE(built.status == 0);
  REQUIRE(subprocess::run_process({.command = {made + "/build/bin/rig_diagram", made}}).succeeded());
  const subprocess::ProcessResult misused =
      subprocess::run_process({.command = {made + "/build/bin/rig_diagram", "--help"}});
  CHECK(misused.status == 2);
  CHECK_THAT(misused.errors, Contains("usage: "));
  CHECK(content_of(made + "/signals.csv") == content_of(folder.path("out/signals.csv")));
  CHECK(content_of(made + "/signals-2.csv") == content_of(folder.path("out/signals-2.csv")));
  CHECK(lines_of(content_of(made + "/signals.csv")).size() > 100);
  const std::string whole = content_of(made + "/signals-2.csv");
  for (const char* limit : {"0", "1", "2", "4"}) {
    const subprocess::ProcessResult full =
        subprocess::run_process({.command = {"sh", "-c", "ulimit -f \"$2\"; exec \"$0\" \"$1\"",
                                             made + "/build/bin/rig_diagram", made, limit}});
    CHECK(full.status == 3);
    CHECK_THAT(full.errors, Contains(".csv: File too large"));
    CHECK(lines_of(full.errors).size() == 1);
    CHECK(content_of(made + "/signals.csv") == content_of(folder.path("out/signals.csv")));
    CHECK(content_of(made + "/signals-2.csv") == whole);
    CHECK_FALSE(std::filesystem::exists(made + "/signals.csv.part"));
  }
}

TEST_CASE("generate says what of a file it leaves out, and what keeps the bits") {
  const Scratch folder;
  folder.file("lags.yaml",
              "stepwire: 1\nstep: 1 ms\nstop: 10 ms\nsolver: rk4\nparameters: {tau: {value: 1 s, doc: x}}\n"
              "sweep: {tau: [1 s, 2 s]}\nblocks: {lag: {block: Lag, u: 1, tau: $tau}}\nrecord: lag\n"
              "claims: [{that: it rises, final: lag, at_least: 0}]\n");
  const Done done = run_program(folder, {"generate", "lags.yaml", "-o", "lags"});
  REQUIRE(done.code == 0);
  CHECK_THAT(done.out,
             Contains("left out: the sweep of tau (what is made has one value of each, the file's or that "
                      "of --set), claims\n") &&
                 Contains("-ffp-contract=off"));
  CHECK_THAT(content_of(folder.path("lags/CMakeLists.txt")),
             Contains("What keeps the bits of `stepwire run`"));
  folder.file("one.yaml",
              "stepwire: 1\nstep: 1 ms\nstop: 10 ms\nblocks: {one: {block: Constant, value: 1}}\n"
              "record: one\n");
  CHECK_THAT(run_program(folder, {"generate", "one.yaml", "-o", "one"}).out, !Contains("left out"));
}

TEST_CASE("generate says how a parameter in a formula can be one that changes") {
  const Scratch folder;
  const std::string head =
      "stepwire: 1\nstep: 1 ms\nstop: 10 ms\nparameters: {k: {value: 2, doc: x}}\nrecord: b\n";
  folder.file("text.yaml",
              head + "blocks: {a: {block: Sine}, b: {block: Expression, expression: u1*$k, u: a}}\n");
  CHECK_THAT(run_program(folder, {"generate", "text.yaml", "-o", "text"}).out,
             Contains("k cannot be changed there: b.expression is a formula; wired as an input of b"));
  folder.file("wire.yaml",
              head + "blocks: {a: {block: Sine}, b: {block: Expression, expression: u1*u2, u: [a, $k]}}\n");
  const std::string chart =
      "stepwire: 1\nstep: 1 ms\nstop: 10 ms\nparameters: {k: {value: 2, doc: x}}\n"
      "record: b.state\nblocks: {a: {block: Sine}, b: {block: StateMachine, ";
  folder.file("chart.yaml", chart + "u: a, states: {off: {to: {on: u > $k}}, on: }}}\n");
  CHECK_THAT(
      run_program(folder, {"generate", "chart.yaml", "-o", "chart"}).out,
      Contains("k cannot be changed there: b.states has formulas, which are code; wired as an input of b"));
  folder.file("wire-chart.yaml", chart + "u: [a, $k], states: {off: {to: {on: u1 > u2}}, on: }}}\n");
  for (const std::string file : {"wire.yaml", "wire-chart.yaml"}) {
    const Done wired = run_program(folder, {"generate", file, "-o", "wire", "--name", "wire"});
    CHECK(wired.code == 0);
    CHECK_THAT(wired.out, !Contains("cannot be changed"));
    CHECK_THAT(content_of(folder.path("wire/wire.hpp")), Contains("k"));
  }
}

TEST_CASE("the struct of a generated program has inputs, outputs and recorded signals as members") {
  const Scratch folder;
  folder.file("rig.yaml", rig_yaml);
  REQUIRE(run_program(folder, {"generate", "rig.yaml", "-o", "rig"}).code == 0);
  const std::string header = content_of(folder.path("rig/rig.hpp"));
  CHECK_THAT(header, Contains("double force_[2]{};  ///< of the hand [N]"));
  CHECK_THAT(header, Contains("double current_{};"));
  CHECK_THAT(header, Contains("double slow_[2]{};"));
  CHECK_THAT(content_of(folder.path("rig/rig.cpp")), Contains("// fast: Lag, rig.yaml:13"));
}

TEST_CASE("a run gives the same bytes with any engine") {
  if (!there_is_a_compiler()) return;
  const Scratch folder;
  folder.file("rig.yaml", rig_yaml);
  for (const std::string engine : {"interpreted", "compiled", "auto"}) {
    const Done done =
        run_program(folder, {.arguments = {"run", "rig.yaml", "--engine", engine, "--out", engine},
                             .environment = {{"STEPWIRE_CACHE", folder.path("cache")}}});
    INFO(done.err);
    CHECK(done.code == 0);
    CHECK(content_of(folder.path(engine + "/signals.csv")) ==
          content_of(folder.path("interpreted/signals.csv")));
  }
  CHECK_THAT(content_of(folder.path("compiled/run.json")), !Contains("\"compiled_ticks\": 0,"));
  CHECK_THAT(content_of(folder.path("interpreted/run.json")), Contains("\"compiled_ticks\": 0,"));
}

TEST_CASE("without a compiler a run says so once and goes on interpreted") {
  const Scratch folder;
  folder.file("lag.yaml", lag_yaml);
  folder.file("too.yaml", lag_yaml);
  const Done done = run_program(folder, {.arguments = {"run", "lag.yaml", "too.yaml", "--engine", "compiled"},
                                         .environment = {{"PATH", "/nowhere"}, {"CXX", {}}}});
  CHECK(done.code == 0);
  CHECK(done.err == "interpreted, since no C++ compiler is there (c++, g++ or clang++, or what CXX names)\n");
}

TEST_CASE("the cache keeps compiled code, and a run goes on compiled where nothing can be kept", "[full]") {
  if (!there_is_a_compiler()) return;
  const Scratch folder;
  folder.file("lag.yaml", lag_yaml);
  const auto run_with = [&](const std::string& cache) {
    return run_program(folder, {.arguments = {"run", "lag.yaml", "--engine", "compiled", "--out", "out"},
                                .environment = {{"STEPWIRE_CACHE", cache}}});
  };
  const auto compiled = [&] {
    return content_of(folder.path("out/run.json")).find("\"compiled_ticks\": 0,") == std::string::npos;
  };
  Done done = run_with(folder.path("cache"));
  CHECK(done.code == 0);
  CHECK(done.err.empty());
  CHECK(compiled());
  const std::filesystem::path kept = std::filesystem::directory_iterator(folder.path("cache"))->path();
  const std::string signals = content_of(folder.path("out/signals.csv")), entry = content_of(kept);
  // A damaged entry of the cache is compiled anew, whatever the damage, and never loaded.
  std::string flipped = entry;
  flipped[flipped.size() / 2] = static_cast<char>(flipped[flipped.size() / 2] ^ 1);
  for (const std::string& bytes : {std::string(), entry.substr(0, 4096), flipped, std::string("garbage")}) {
    std::ofstream(kept, std::ios::binary | std::ios::trunc) << bytes;
    done = run_with(folder.path("cache"));
    CHECK(done.code == 0);
    CHECK(done.err.empty());
    CHECK(compiled());
    CHECK(content_of(folder.path("out/signals.csv")) == signals);
    CHECK(content_of(kept).size() == entry.size());
  }
  done = run_with("/proc/nowhere");
  CHECK(done.code == 0);
  CHECK(compiled());
  CHECK_THAT(done.err, Catch::StartsWith("the cache keeps nothing: /proc/nowhere: "));
  std::filesystem::permissions(folder.path("cache"), std::filesystem::perms::others_read,
                               std::filesystem::perm_options::add);
  done = run_with(folder.path("cache"));
  CHECK(done.code == 0);
  CHECK(compiled());
  CHECK_THAT(done.err, Contains("is open to other users") && Contains("chmod 700"));
}

TEST_CASE("a diagram file of any name becomes a program, whatever the words of C++, CMake and libraries are",
          "[full]") {
  if (!there_is_a_compiler()) return;
  const Scratch folder;
  std::string super = "cmake_minimum_required(VERSION 3.16)\nproject(all_of_them LANGUAGES CXX)\n";
  const std::vector<std::pair<std::string, std::string>> names{
      {"main", "main"},       {"int", "int"},
      {"reset", "reset"},     {"all", "all"},
      {"install", "install"}, {"std", "std"},
      {"struct", "struct"},   {"1abc", "_1abc"},
      {"a b.c", "a_b_c"},     {"x;touch executed;\n${y}", "x_touch_executed____y_"}};
  for (const auto& [file, program] : names) {
    folder.file(file + ".yaml", lag_yaml);
    const Done done = run_program(folder, {"generate", file + ".yaml", "-o", "made/" + program});
    INFO(done.err);
    REQUIRE(done.code == 0);
    super += "add_subdirectory(" + program + ")\nset_target_properties(" + program +
             "_diagram_main PROPERTIES EXCLUDE_FROM_ALL FALSE)\n";
  }
  folder.file("made/CMakeLists.txt", super);
  const std::string made = folder.path("made");
  REQUIRE(subprocess::run_process({.command = {"cmake", "-S", made, "-B", made + "/build", "-G", "Ninja"}})
              .succeeded());
  const subprocess::ProcessResult built = subprocess::run_process(
      {.command = {"cmake", "--build", made + "/build"}, .limit = subprocess::compiler_limit()});
  INFO(built.output);
  REQUIRE(built.succeeded());
  REQUIRE(run_program(folder, {"run", "main.yaml", "--out", "out"}).code == 0);
  for (const auto& [file, program] : names) {
    REQUIRE(subprocess::run_process(
                {.command = {made + "/build/" + program + "/bin/" + program + "_diagram", made}})
                .succeeded());
    CHECK(content_of(made + "/signals.csv") == content_of(folder.path("out/signals.csv")));
  }
  CHECK_FALSE(std::filesystem::exists(folder.path("executed")));
}

TEST_CASE("what an older generate left goes from its folder, and a file of one's own stays") {
  const Scratch folder;
  folder.file("lag.yaml", lag_yaml);
  REQUIRE(run_program(folder, {"generate", "lag.yaml", "-o", "made", "--name", "first"}).code == 0);
  folder.file("made/notes.txt", "mine");
  REQUIRE_FALSE(content_of(folder.path("made/first.cpp")).empty());
  REQUIRE(run_program(folder, {"generate", "lag.yaml", "-o", "made", "--name", "second"}).code == 0);
  CHECK_FALSE(content_of(folder.path("made/second.cpp")).empty());
  CHECK(content_of(folder.path("made/first.cpp")).empty());
  CHECK(content_of(folder.path("made/notes.txt")) == "mine");
}

TEST_CASE("an option without its value is refused, and takes none of the next words for it") {
  const Scratch folder;
  folder.file("lag.yaml", lag_yaml);
  for (const std::vector<std::string>& words :
       {std::vector<std::string>{"generate", "lag.yaml", "-o", "made", "--name=", "--c-api"},
        {"generate", "lag.yaml", "-o", ""},
        {"thesis", "--only", ""},
        {"run", "lag.yaml", "--set", ""}}) {
    const Done done = run_program(folder, words);
    INFO(words.back() << done.out);
    CHECK(done.code == 2);
    CHECK_THAT(done.err, Contains("has no value"));
  }
}

}  // namespace stepwire::cli
