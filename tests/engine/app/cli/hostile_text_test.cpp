// Text of a diagram never becomes code, markup, a word of a shell or a command of a terminal.
#include <algorithm>
#include <catch2/catch.hpp>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "engine/base/json/json.hpp"
#include "engine/base/subprocess/process.hpp"
#include "engine/base/text/characters.hpp"
#include "engine/simulate/codegen/compiler.hpp"
#include "tests/engine/app/cli/hostile.hpp"
#include "tests/engine/app/cli/program.hpp"

namespace stepwire::cli {
using Catch::Contains;

namespace {

/// A text in quotes of YAML, which are those of JSON.
std::string in_yaml(const std::string& text) {
  return json::Json(text).text(-1);
}

/// A text as far as a file can have it for its name.
std::string file_name(std::string text) {
  std::replace(text.begin(), text.end(), '/', '|');
  std::replace(text.begin(), text.end(), '\0', '0');
  return text + ".yaml";
}

const std::string part_yaml =
    "stepwire: 1\ninputs: {u: {doc: TEXT}}\noutputs: {y: lag}\nparameters: {tau: {value: 0.1 s, doc: TEXT}}\n"
    "blocks:\n  lag: {block: Lag, u: u, tau: $tau}\n";

std::string with_text(std::string yaml, const std::string& text) {
  for (std::size_t at = 0; (at = yaml.find("TEXT", at)) != std::string::npos; at += text.size())
    yaml.replace(at, 4, text);
  return yaml;
}

/// Makes a diagram that has each of these texts at every place that takes a text.
std::string hostile_yaml(const Scratch& folder, const std::string& title) {
  const std::vector<std::string> texts = hostile_texts();
  std::string inputs = "inputs:\n", outputs = "outputs:\n", blocks = "blocks:\n", record = "record: [",
              figures = "figure:\n", claims = "claims:\n";
  for (std::size_t i = 0; i < texts.size(); ++i) {
    const std::string number = std::to_string(i), text = in_yaml(texts[i]), part = file_name(texts[i]);
    folder.file(part, with_text(part_yaml, text));
    inputs += "  in" + number + ": {default: " + number + ", doc: " + text + "}\n";
    outputs += "  out" + number + ": {signal: part" + number + ", doc: " + text + "}\n";
    blocks += "  part" + number + ": {diagram: " + in_yaml(part) + ", u: in" + number + "}\n";
    record += (i == 0 ? "" : ", ") + ("part" + number);
    figures += "  - {plot: lines, title: " + text + ", caption: " + text + ", x: time, y: part" + number +
               ", x_label: " + text + ", y_label: " + text + ", legend: [" + text + "]}\n";
    claims += "  - {that: " + text + ", final: part" + number + ", at_most: -1, disagrees: " + text + "}\n";
  }
  return "stepwire: 1\ntitle: " + in_yaml(title) + "\ncaption: " + in_yaml(title) +
         "\nstep: 1 ms\nstop: 0.05 s\nsolver: rk4\n" + inputs + outputs + blocks + record + "]\n" + figures +
         claims;
}

std::string all_hostile() {
  std::string all;
  for (const std::string& text : hostile_texts()) all += text + " ";
  return all + "\\";
}

}  // namespace

TEST_CASE("hostile texts everywhere in a diagram are compiled to the interpreter's bits and execute nothing",
          "[full]") {
  if (!codegen::Compiler().found()) {
    WARN("there is no C++ compiler here; nothing was compared");
    return;
  }
  const Scratch folder;
  folder.file("all.yaml", hostile_yaml(folder, all_hostile()));
  for (const std::string engine : {"interpreted", "compiled"}) {
    const Done done =
        run_program(folder, {.arguments = {"run", "all.yaml", "--engine", engine, "--out", engine},
                             .environment = {{"STEPWIRE_CACHE", folder.path("cache")}}});
    INFO(done.err);
    CHECK(done.code <= 1);
    CHECK(done.err.empty());
  }
  CHECK(content_of(folder.path("compiled/signals.csv")) ==
        content_of(folder.path("interpreted/signals.csv")));
  CHECK_THAT(content_of(folder.path("compiled/run.json")), !Contains("\"compiled_ticks\": 0,"));
  REQUIRE(run_program(folder, {"generate", "all.yaml", "--c-api", "-o", "made"}).code == 0);
  const std::string made = folder.path("made");
  REQUIRE(subprocess::run_process({.command = {"cmake", "-S", made, "-B", made + "/build", "-G", "Ninja"}})
              .succeeded());
  const subprocess::ProcessResult built = subprocess::run_process(
      {.command = {"cmake", "--build", made + "/build"}, .limit = subprocess::compiler_limit()});
  INFO(built.output);
  REQUIRE(built.succeeded());
  REQUIRE(subprocess::run_process({.command = {made + "/build/bin/all_diagram", made}}).succeeded());
  CHECK(content_of(made + "/signals.csv") == content_of(folder.path("interpreted/signals.csv")));
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder.path("")))
    CHECK(entry.path().filename() != "executed");
}

TEST_CASE("hostile texts reach pictures, pages and the terminal without control characters or markup",
          "[full]") {
  const Scratch folder;
  folder.file("all.yaml", hostile_yaml(folder, all_hostile()));
  const Done done = run_program(folder, {"run", "all.yaml", "--out", "out"});
  INFO(done.err);
  CHECK(text::visible_lines(done.out) == done.out);
  const std::size_t texts = hostile_texts().size();
  CHECK(lines_of(done.out).size() ==
        texts + 3);  // title, counts, a line for each claim, and where it is written
  CHECK_THAT(done.out, Contains("two\\nlines") && Contains("right \\u202e to left"));
  for (std::size_t i = 0; i < texts; ++i) {
    const std::string svg =
        content_of(folder.path("out/figure" + (i == 0 ? "" : "-" + std::to_string(i + 1)) + ".svg"));
    INFO(i);
    CHECK_THAT(svg, Contains("</svg>"));
    CHECK(text::printable(svg) == svg);
    CHECK_THAT(svg, !Contains("<script"));
    const subprocess::ProcessResult parsed = subprocess::run_process(
        {.command = {"python3", "-c",
                     "import sys, xml.dom.minidom as m; m.parseString(sys.stdin.buffer.read())"},
         .input = svg});
    INFO(parsed.errors);
    CHECK((parsed.succeeded() || parsed.end == subprocess::ProcessResult::End::not_started));
  }
  const auto claims = nlohmann::json::parse(content_of(folder.path("out/claims.json")));
  REQUIRE(claims.size() == texts);
  for (std::size_t i = 0; i < texts; ++i) CHECK(claims[i]["that"] == hostile_texts()[i]);
  CHECK_FALSE(std::filesystem::exists(folder.path("executed")));
}

TEST_CASE("a message about a hostile text is one line that a terminal shows as it is") {
  const Scratch folder;
  for (const std::string& text : hostile_texts()) {
    folder.file("a.yaml",
                "stepwire: 1\nstep: 1 s\nstop: 1 s\nblocks:\n  lag: {block: " + in_yaml(text) + "}\n");
    for (const std::vector<std::string>& call : {std::vector<std::string>{"check", "a.yaml"},
                                                 {"blocks", text.substr(0, text.find('\0'))},
                                                 {"run", file_name(text)}}) {
      const Done done = run_program(folder, call);
      INFO(done.err);
      CHECK(done.code == 2);
      CHECK(text::visible_lines(done.err) == done.err);
    }
  }
}

}  // namespace stepwire::cli
