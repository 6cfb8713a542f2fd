// Content of an exported unit, and its behaviour when it is imported, whole or damaged.
#include "engine/app/fmu/unit_export.hpp"

#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <sstream>

#include "engine/base/archive/archive.hpp"
#include "engine/base/fmi/package.hpp"
#include "engine/base/fmi/unit_error.hpp"
#include "engine/base/io/file.hpp"
#include "engine/base/subprocess/process.hpp"
#include "engine/base/text/characters.hpp"
#include "engine/base/yaml/error.hpp"
#include "tests/engine/app/fmu/exported.hpp"
#include "tests/support/plan_text.hpp"
#include "tests/support/run_text.hpp"
#include "tests/support/units/schema.hpp"

namespace stepwire::fmu {

namespace {

using Catch::Contains;

const std::string head = "stepwire: 1\ntitle: a unit\nstep: 10 ms\nstop: 1 s\nsolver: rk4\n";

std::string import_text(const std::string& path, const std::string& keys = "") {
  return fmt::format("step: 10 ms\nstop: 1 s\nsolver: rk4\nblocks:\n  unit: {{block: Fmu, file: {}{}}}\n",
                     path, keys);
}

std::string refusal(const Scratch& folder, const std::string& yaml) {
  try {
    unit_files(folder, "a", yaml, 3);
  } catch (const yaml::Error& error) {
    return error.what();
  }
  return "";
}

/// Returns the documentation page of a unit, which describes its model exchange.
std::string page_of(const std::string& yaml) {
  const Scratch folder;
  return unit_files(folder, "a", yaml, 3).at("documentation/index.html");
}

const std::string lag = head + "blocks:\n  a: {block: Lag, u: 1, tau: 0.3 s}\nrecord: [a]\n";

}  // namespace

TEST_CASE("texts of a diagram stay texts in the description and on the page", "[full]") {
  if (!there_is_a_compiler()) return;
  const Scratch folder;
  const std::string text = R"("<script>alert(1)</script> & \"quotes\" 'and' ]]> --> \e[2J \x01 größe")";
  auto files = unit_files(folder, "a \"b\" <c> & d",
                          "stepwire: 1\ntitle: " + text +
                              "\nstep: 10 ms\nstop: 1 s\ninputs: {u: {default: 0, doc: " + text +
                              "}}\nparameters: {k: {value: 2, doc: " + text +
                              "}}\nblocks: {a: {block: Gain, u: u, gain: $k}}\nrecord: [a]\n",
                          GENERATE(3, 2));
  for (const char* file : {"modelDescription.xml", "documentation/index.html"}) {
    INFO(file);
    CHECK_THAT(files.at(file), Contains("&lt;script&gt;alert(1)&lt;/script&gt; &amp; &quot;quotes&quot;"));
    CHECK_THAT(files.at(file), !Contains("<script>"));
  }
}

TEST_CASE("recorded signals without elements are no variables", "[full]") {
  if (!there_is_a_compiler()) return;
  const Scratch folder;
  const std::string text = unit_files(folder, "a",
                                      head +
                                          "blocks: {d: {block: Demux, u: 0.5, sizes: [1, 1, 2]}}\n"
                                          "record: all\n",
                                      3)
                               .at("modelDescription.xml");
  CHECK_THAT(text, Contains("\"d.y3\""));
  CHECK_THAT(text, !Contains("\"d.y4\""));
  CHECK_THAT(text, !Contains("start=\"0\"/>"));  // of a dimension
}

TEST_CASE("a parameter makes room for a signal of its name, and two signals of one name are refused",
          "[full]") {
  if (!there_is_a_compiler()) return;
  const Scratch folder;
  const std::string blocks =
      "parameters: {a: 2}\nblocks:\n  a: {block: Gain, u: b, gain: $a}\n  b: {block: Clock}\n";
  const std::string xml =
      unit_files(folder, "a", head + blocks + "record: [a]\n", 3).at("modelDescription.xml");
  CHECK_THAT(xml, Contains("name=\"parameter.a\"") && Contains("name=\"a\""));
  const std::string clash =
      refusal(folder, head + blocks + "outputs: {a: {signal: b, safe: 0}}\nrecord: [a]\n");
  CHECK_THAT(clash, Contains("a.yaml:") && Contains("'a' would have the name of another variable"));
}

TEST_CASE("model exchange is left out with the reason where a diagram is more than its equations", "[full]") {
  if (!there_is_a_compiler()) return;
  CHECK_THAT(page_of(lag), Contains("By model exchange"));
  CHECK_THAT(page_of(head + "blocks:\n  a: {block: UnitDelay, u: 1, every: 20 ms}\nrecord: [a]\n"),
             Contains("There is no model exchange: a works every 0.02 s"));
  CHECK_THAT(
      page_of(head + "blocks:\n  a: {block: Delay, u: t, delay: 50 ms}\n  t: {block: Clock}\nrecord: [a]\n"),
      Contains("There is no model exchange: a "));
  CHECK_THAT(page_of(head + "algebraic_loops: solve\nblocks:\n  a: {block: Sum, u: [b, 1]}\n"
                            "  b: {block: Gain, u: a, gain: -0.5}\nrecord: [a]\n"),
             Contains("There is no model exchange: the algebraic loop"));
}

TEST_CASE("a controller with limits of its output is exported for model exchange", "[full]") {
  if (!there_is_a_compiler()) return;
  const auto page_with = [](const std::string& keys) {
    return page_of(head + "events: locate\nblocks:\n  t: {block: Clock}\n  a: {block: PID, u: t, " + keys +
                   "}\nrecord: [a]\n");
  };
  CHECK_THAT(page_with("ki: 2, kd: 1, lower: -1, upper: 1, settled: false, anti_windup: none"),
             Contains("By model exchange"));
  for (const char* keys : {"ki: 2, kd: 1, upper: 1", "ki: 2, upper: 1, settled: false",
                           "ki: 2, integral_upper: 1, settled: false"})
    CHECK_THAT(page_with(keys), Contains("There is no model exchange: a remembers at every step") &&
                                    Contains("settled: false and without a reset"));
}

TEST_CASE("a controller with one limit of its output meets it by model exchange as in the diagram",
          "[full]") {
  if (!there_is_a_compiler()) return;
  const Scratch folder;
  // y = u + 2 int(u) with u = 1 meets its limit 2 at 0.5 s. From 0.73 s on u = -1, and y = 0.46 - 2 (t - 0.73
  // s).
  const std::string path = exported(
      folder, "a",
      head +
          "events: locate\ninputs: {u: {default: 0}}\nblocks:\n"
          "  a: {block: PID, u: u, kp: 1, ki: 2, upper: 2, settled: false, anti_windup: none}\nrecord: [a]\n",
      3);
  const table::Table unit = run_text(
      import_text(path, ", interface: model_exchange, u: wave") +
      "  wave: {block: Step, time: 0.73 s, before: 1, after: -1}\nevents: locate\nrecord: [unit.a]\n");
  CHECK(column(unit, "unit.a")[40] == Approx(1.8));
  CHECK(column(unit, "unit.a")[70] == Approx(2.0));
  CHECK(column(unit, "unit.a").back() == Approx(-0.08));
}

TEST_CASE("by model exchange inputs are those of the instant: the bits are those of the diagram itself",
          "[full]") {
  if (!there_is_a_compiler()) return;
  const Scratch folder;
  const std::string plant = "  a: {block: Lag, u: %, tau: 0.3 s}\n  b: {block: Integrator, u: a}\n";
  const auto with = [&](const std::string& input) {
    return std::string(plant).replace(plant.find('%'), 1, input);
  };
  const std::string path =
      exported(folder, "a", head + "inputs: {u: {default: 0}}\nblocks:\n" + with("u") + "record: [a, b]\n",
               GENERATE(3, 2));
  const std::string wave = "  wave: {block: Sine, frequency: 2 Hz}\n";
  const table::Table own =
      run_text("step: 10 ms\nstop: 1 s\nsolver: rk4\nblocks:\n" + wave + with("wave") + "record: [a, b]\n");
  const table::Table unit = run_text(import_text(path, ", interface: model_exchange, u: wave") + wave +
                                     "record: [unit.a, unit.b]\n");
  CHECK(column(unit, "unit.a") == column(own, "a"));
  CHECK(column(unit, "unit.b") == column(own, "b"));
}

TEST_CASE("a unit has more than a hundred ports, and each is fed and shown in its place", "[full]") {
  if (!there_is_a_compiler()) return;
  const Scratch folder;
  std::string inputs, blocks, fed, record;
  constexpr int count = 150;
  for (int i = 0; i < count; ++i) {
    inputs += fmt::format("{}u{}: {{default: 0}}", i == 0 ? "" : ", ", i);
    blocks += fmt::format("  y{0}: {{block: Gain, u: u{0}, gain: 2}}\n", i);
    fed += fmt::format(", u{}: {}", i, i + 1);
    record += fmt::format("{}unit.y{}", i == 0 ? "" : ", ", i);
  }
  const std::string path =
      exported(folder, "a", head + "inputs: {" + inputs + "}\nblocks:\n" + blocks + "record: all\n");
  const table::Table run =
      run_text(import_text(path, ", interface: model_exchange" + fed) + "record: [" + record + "]\n");
  for (int i = 0; i < count; ++i) CHECK(column(run, fmt::format("unit.y{}", i)).back() == 2.0 * (i + 1));
}

TEST_CASE("what depends on what, and which powers of base units a unit is, stand in the description") {
  if (!there_is_a_compiler()) return;
  const Scratch folder;
  const std::string xml =
      unit_files(folder, "a",
                 head +
                     "inputs: {f: {unit: N, default: 0 N}, g: {unit: N, default: 0 N}}\n"
                     "parameters: {m: {value: 500 g, above: 0 kg}}\n"
                     "blocks:\n  sum:  {block: Sum, u: [f, g]}\n  mass: {block: Mass, force: f, mass: $m}\n"
                     "record: [sum, mass.velocity]\n",
                 3)
          .at("modelDescription.xml");
  // 0 time, 1 m, 2 f, 3 g, 4 sum, 5 mass.velocity, then the other state and the slopes.
  CHECK_THAT(xml, Contains("<Output valueReference=\"4\" dependencies=\"2 3\"/>"));
  CHECK_THAT(xml, Contains("<Output valueReference=\"5\" dependencies=\"5 6\"/>") ||
                      Contains("<Output valueReference=\"5\" dependencies=\"5 7\"/>"));
  CHECK_THAT(xml, Contains("dependencies=\"2 5 6\"/>") || Contains("dependencies=\"2 5 7\"/>"));
  CHECK_THAT(xml, Contains("<BaseUnit m=\"1\" kg=\"1\" s=\"-2\"/>"));
  CHECK_THAT(xml, Contains("<DisplayUnit name=\"g\" factor=\"1000\"/>"));
  CHECK_THAT(xml, Contains("displayUnit=\"g\" min=\"0\" start=\"0.5\""));
}

TEST_CASE("both outputs of a solved loop depend on all of its inputs", "[full]") {
  if (!there_is_a_compiler()) return;
  const Scratch folder;
  const std::string xml =
      unit_files(folder, "a",
                 head +
                     "algebraic_loops: solve\ninputs: {u: {default: 0}, v: {default: 0}}\n"
                     "blocks:\n  a: {block: Sum, u: [u, half]}\n  b: {block: Sum, u: [v, third]}\n"
                     "  half: {block: Gain, u: b, gain: 0.5}\n  third: {block: Gain, u: a, gain: 0.3}\n"
                     "record: [a, b]\n",
                 3)
          .at("modelDescription.xml");
  // 0 time, 1 u, 2 v, 3 a, 4 b.
  CHECK_THAT(xml, Contains("<Output valueReference=\"3\" dependencies=\"1 2\"/>"));
  CHECK_THAT(xml, Contains("<Output valueReference=\"4\" dependencies=\"1 2\"/>"));
}

TEST_CASE("a unit ends the run at the tick at which its diagram ends", "[full]") {
  if (!there_is_a_compiler()) return;
  const Scratch folder;
  const std::string path = exported(
      folder, "a", head + "stop_when: a > 0.5\nblocks: {a: {block: Clock}}\nrecord: [a]\n", GENERATE(3, 2));
  const auto run = result_of(import_text(path, ", interface: co_simulation") + "record: [unit.a]\n");
  CHECK(run.faults.empty());
  REQUIRE(run.diagnostics.size() == 1);
  CHECK(run.diagnostics[0].text == "the unit has ended the run");
  CHECK(column(run.recordings.front().table, "time").back() == 0.51);
  CHECK(column(run.recordings.front().table, "unit.a").back() == 0.51);
}

TEST_CASE("a unit whose diagram ends between two ticks ends an importing run without a fault", "[full]") {
  if (!there_is_a_compiler()) return;
  const Scratch folder;
  const std::string path = exported(folder, "a",
                                    head +
                                        "events: locate\nstop_when: x > 0.505\nblocks: {one: {block: "
                                        "Constant, value: 1 1/s}, x: {block: Integrator, u: one}}\n"
                                        "record: [x]\n",
                                    GENERATE(3, 2));
  const auto run = result_of(import_text(path, ", interface: co_simulation") + "record: [unit.x]\n");
  CHECK(run.faults.empty());
  REQUIRE(run.diagnostics.size() == 1);
  CHECK(run.diagnostics[0].text == "the unit has ended the run");
  CHECK(column(run.recordings.front().table, "unit.x").back() == Approx(0.505));
}

TEST_CASE("the sources alone make a binary with the same bits, which shows the functions of FMI alone",
          "[full]") {
  if (!there_is_a_compiler()) return;
  const Scratch folder;
  auto files = unit_files(folder, "a", lag, 3);
  const std::string before = exported(folder, "before", lag);
  for (const auto& [path, text] : files) io::write_file(folder.path("unit/" + path), text);
  CHECK(testing::schema_fault(folder.path("unit/sources/buildDescription.xml"), 3, "BuildDescription") == "");
  const std::string& build = files.at("sources/buildDescription.xml");
  const std::size_t at = build.find("compilerOptions=\"") + 17;
  std::istringstream options(build.substr(at, build.find('"', at) - at));
  subprocess::ProcessCall call{.command = {"c++"}, .limit = subprocess::compiler_limit()};
  for (std::string option; options >> option;) call.command.push_back(option);
  const std::string sources = folder.path("unit/sources"), binary = folder.path("a.so");
  call.command.insert(call.command.end(),
                      {"-w", "-fPIC", "-shared", "-I", sources, sources + "/fmi-unit.cpp",
                       "-Wl,--version-script=" + sources + "/fmi-unit.map", "-o", binary});
  const subprocess::ProcessResult made = subprocess::run_process(call);
  INFO(made.errors);
  REQUIRE(made.succeeded());
  files[fmi::binary_folder(3) + "a.so"] = io::read_file(binary);
  io::write_file(folder.path("after.fmu"), archive::archive_bytes(files));
  const std::string record = "record: [unit.a]\n";
  CHECK(column(run_text(import_text(before) + record), "unit.a") ==
        column(run_text(import_text(folder.path("after.fmu")) + record), "unit.a"));
  const subprocess::ProcessResult symbols =
      subprocess::run_process({.command = {"nm", "-D", "--defined-only", binary}});
  if (!symbols.succeeded()) return;
  std::istringstream lines(symbols.output);
  for (std::string line; std::getline(lines, line);) CHECK_THAT(line, Contains(" T fmi3"));
}

TEST_CASE("the same diagram gives the same bytes", "[full]") {
  if (!there_is_a_compiler()) return;
  const Scratch folder;
  const std::string once = io::read_file(exported(folder, "a", lag));
  CHECK(once == io::read_file(exported(folder, "a", lag)));
}

TEST_CASE("an exported unit that is cut or changed is refused, and nothing crashes", "[full]") {
  if (!there_is_a_compiler()) return;
  const Scratch folder;
  const std::string whole = io::read_file(exported(folder, "a", lag));
  constexpr std::size_t tries = 100;
  std::size_t refused = 0;
  for (std::size_t i = 0; i < tries; ++i) {
    const std::size_t at = whole.size() * i / tries;
    std::string changed = whole;
    changed[at] = static_cast<char>(changed[at] ^ 0x10);
    for (const std::string& bytes : {whole.substr(0, at), changed}) {
      const std::string path = folder.file(fmt::format("{}-{}.fmu", i, bytes.size()), bytes);
      try {
        fmi::open_package(path);
      } catch (const fmi::UnitError& error) {
        CHECK_THAT(error.what(), Contains(path));
        ++refused;
      }
    }
  }
  CHECK(refused > tries);
}

TEST_CASE("a description that does not fit its binary is a fault in one sentence", "[full]") {
  if (!there_is_a_compiler()) return;
  const Scratch folder;
  const auto files = unit_files(folder, "a", lag, 3);
  const auto edited = [&](const std::map<std::string, std::string>& changes) {
    auto other = files;
    for (const auto& [what, by] : changes) text::replace_all(other.at("modelDescription.xml"), what, by);
    const std::string path = folder.path("edited.fmu");
    io::write_file(path, archive::archive_bytes(other));
    return error_of(import_text(path, ", interface: co_simulation") + "record: [unit.a]\n");
  };
  CHECK_THAT(edited({{"instantiationToken=\"{", "instantiationToken=\"{0"}}),
             Contains("token is not that of this unit"));
  CHECK_THAT(
      edited({{"valueReference=\"1\"", "valueReference=\"77\""}, {"derivative=\"1\"", "derivative=\"77\""}}),
      Contains("value reference 77"));
  CHECK_THAT(edited({{"modelIdentifier=\"a\"", "modelIdentifier=\"b\""}}), Contains("b.so"));
}

}  // namespace stepwire::fmu
