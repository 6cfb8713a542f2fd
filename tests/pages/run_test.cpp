// Pages are executed: their diagrams run, their commands print the shown output, and their sources are pieces
// of the files that they name.
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>
#include <sstream>

#include "tests/pages/command.hpp"
#include "tests/pages/diagram_text.hpp"
#include "tests/pages/page.hpp"
#include "tests/pages/workbench.hpp"

namespace {

namespace fs = std::filesystem;
constexpr int surroundings = 3;  // the exit code where node, gnuplot or data are not on this machine

/// State of the execution of a page: its folder, and the last diagram shown.
struct Reading {
  const Page& page;
  Workbench bench{};
  std::string last_diagram{};
};

/// The name of the file that a block of code is, from the paragraph before it; empty if that names none.
std::string name_of(const Fence& fence) {
  std::string name;
  for (const std::string& code : code_in(fence.lead))
    if (std::regex_match(code, std::regex(R"([\w-]+\.)" + fence.language))) name = code;
  return name;
}

/// The sources that a paragraph links to, with this ending.
std::vector<std::string> sources_from(const Page& page, const Fence& fence, const std::string& ending) {
  std::vector<std::string> sources;
  for (const std::string& link : links_in(fence.lead))
    if (link.ends_with(ending)) sources.push_back(target_of(page, link));
  return sources;
}

bool stands_in_one_of(const Fence& fence, const std::vector<std::string>& files) {
  for (const std::string& file : files)
    if (stands_in(fence.text, content_of(fs::path(STEPWIRE_SOURCE_DIR) / file))) return true;
  return false;
}

void expect(const Outcome& outcome, int code, const std::string& command) {
  if (outcome.code == surroundings && code != surroundings) {
    WARN("skipped: " << command << ": " << outcome.output);
    return;
  }
  INFO(command << "\n" << outcome.output);
  CHECK(outcome.code == code);
}

void do_command(const Reading& reading, const std::string& command) {
  INFO(command);
  CHECK(fault_of(command).empty());
  if (is_run(command)) expect(reading.bench.run(command), 0, command);
}

void run_diagram(const Reading& reading, const std::string& name, const std::string& yaml) {
  reading.bench.write(name, yaml);
  expect(reading.bench.run("./stepwire run " + name), 0, "run " + name);
}

void do_yaml(Reading& reading, const Fence& fence) {
  const std::string named = name_of(fence);
  const std::string name = named.empty() ? "line-" + std::to_string(fence.first.number) + ".yaml" : named;
  const auto sources = sources_from(reading.page, fence, ".yaml");
  if (is_diagram(fence.text)) {
    if (is_part(fence.text)) return reading.bench.write(name, fence.text);
    reading.last_diagram = fence.text;
    run_diagram(reading, name, fence.text);
  } else if (!sources.empty()) {
    CHECK(stands_in_one_of(fence, sources));
  } else if (!named.empty()) {
    reading.bench.write(named, fence.text);
  } else {
    REQUIRE_FALSE(reading.last_diagram.empty());
    run_diagram(reading, name, with_sections(reading.last_diagram, fence.text));
  }
}

/// How long something took differs each time.
std::string without_seconds(const std::string& line) {
  return std::regex_replace(line, std::regex(R"([0-9.e-]+ s(?=;|$))"), "_ s");
}

/// Checks that the shown lines are printed in their order; a page may leave lines out.
void check_shown(const std::vector<std::string>& shown, const std::string& printed) {
  std::istringstream stream(printed);
  std::string line;
  for (const std::string& expected : shown) {
    bool found = false;
    while (!found && std::getline(stream, line)) found = without_seconds(line) == without_seconds(expected);
    INFO("expected: " << expected << "\nprinted:\n" << printed);
    CHECK(found);
  }
}

/// 1 where a claim is shown to fail, diagrams to differ or blocks to be missing, 2 where a place in a file is
/// shown.
int code_of(const std::vector<std::string>& shown) {
  int code = 0;
  for (const std::string& line : shown) {
    if (line.starts_with("  FAIL ") || line.starts_with("  placeholder ")) code = 1;
    if (std::regex_search(line, std::regex("^    [+~>-] "))) code = 1;
    if (std::regex_search(line, std::regex(R"(^[\w./-]+\.yaml:\d+:\d+: )"))) code = 2;
  }
  return code;
}

void do_call(const Reading& reading, const std::string& command, const std::vector<std::string>& shown) {
  INFO(command);
  REQUIRE((is_run(command) || command.starts_with("sed ")));
  const Outcome outcome = reading.bench.run(command);
  expect(outcome, code_of(shown), command);
  if (outcome.code != surroundings) check_shown(shown, outcome.output);
}

void do_console(const Reading& reading, const Fence& fence) {
  std::istringstream stream(fence.text);
  std::string command;
  std::vector<std::string> shown;
  for (std::string line; std::getline(stream, line);) {
    if (!line.starts_with("$ ")) {
      shown.push_back(line);
      continue;
    }
    if (!command.empty()) do_call(reading, command, shown);
    command = line.substr(2);
    shown.clear();
  }
  do_call(reading, command, shown);
}

void do_commands(const Reading& reading, const Fence& fence) {
  std::istringstream stream(fence.text);
  for (std::string line; std::getline(stream, line);)
    if (!line.empty() && !line.starts_with("#")) do_command(reading, line);
}

void do_fence(Reading& reading, const Fence& fence) {
  INFO(fence.first.place());
  if (fence.language == "yaml") do_yaml(reading, fence);
  if (fence.language == "console") do_console(reading, fence);
  if (fence.language == "sh") do_commands(reading, fence);
  if (fence.language == "csv") reading.bench.write(name_of(fence), fence.text);
  if (fence.language == "json") CHECK_NOTHROW(nlohmann::json::parse(fence.text));
  if (std::set<std::string>{"cpp", "c", "cmake"}.contains(fence.language))
    CHECK(stands_in_one_of(fence, sources_from(reading.page, fence, "pp")));
}

void do_prose(const Reading& reading) {
  for (const std::string& paragraph : paragraphs_of(reading.page))
    for (const std::string& code : code_in(paragraph))
      if (is_command(code)) do_command(reading, code);
}

/// The name of the result in a paragraph of which the next one shows the picture: `out/tank/figure.svg`.
std::string result_in(const std::string& paragraph) {
  std::string name;
  for (const std::string& code : code_in(paragraph))
    if (code.starts_with("out/") && code.ends_with(".svg")) name = code;
  return name;
}

/// Checks that the pictures of a page are the results that its commands have left in the folder.
void check_pictures(const Reading& reading) {
  std::string result;
  for (const std::string& paragraph : paragraphs_of(reading.page)) {
    const std::vector<std::string> links = links_in(paragraph);
    if (paragraph.starts_with("![") && !result.empty() && !links.empty()) {
      const Outcome made = reading.bench.run("cat " + result);
      INFO(reading.page.file << ": " << links.front() << " is " << result);
      if (made.code != 0)
        WARN("skipped: " << made.output);
      else
        CHECK((made.output ==
               content_of(fs::path(STEPWIRE_SOURCE_DIR) / target_of(reading.page, links.front()))));
    }
    result = result_in(paragraph);
  }
}

}  // namespace

TEST_CASE("every diagram, command and source of a page is as it stands there") {
  for (const Page& page : all_pages()) {
    INFO(page.file);
    Reading reading{page};
    for (const Fence& fence : page.fences) do_fence(reading, fence);
    do_prose(reading);
    check_pictures(reading);
  }
}

TEST_CASE("a piece of a diagram adds blocks and replaces what is recorded") {
  const std::string diagram = "stepwire: 1\nblocks:\n  a: {block: Clock}\nrecord: a\n";
  CHECK(with_sections(diagram, "blocks:\n  b: {block: Clock}\nrecord: b\n") ==
        "stepwire: 1\nblocks:\n  a: {block: Clock}\n  b: {block: Clock}\nrecord: b\n");
}

TEST_CASE("a command with an unknown option, target or file is refused") {
  CHECK(fault_of("./stepwire run cart.yaml --out out").empty());
  CHECK(fault_of("./stepwire run cart.yaml --otu out") == "run has no option --otu");
  CHECK(fault_of("./stepwire walk cart.yaml") == "no verb walk");
  CHECK(fault_of("build/tests/test_house").empty());
  CHECK(fault_of("build/tests/test_hose") == "no target test_hose");
  CHECK(fault_of("bench/runs") == "no file bench/runs");
  CHECK(fault_of("cmake --preset quick") == "no preset quick");
}
