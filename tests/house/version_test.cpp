// The version of the program has one place, project(VERSION) of CMakeLists.txt.
#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <regex>
#include <string>

#include "tests/house/source_tree.hpp"

namespace {

/// Returns what the first match of a pattern in a file captures; empty without a match.
std::string first_in(const std::string& file, const std::string& pattern) {
  const std::regex form(pattern);
  std::smatch match;
  for (const Line& line : lines_of(file))
    if (std::regex_search(line.text, match, form)) return match[1];
  return "";
}

std::string version_of_project() {
  return first_in("CMakeLists.txt", R"(^project\(stepwire VERSION (\d+\.\d+\.\d+) )");
}

nlohmann::json read(const std::string& file) {
  return nlohmann::json::parse(std::ifstream(std::filesystem::path(STEPWIRE_SOURCE_DIR) / file));
}

}  // namespace

TEST_CASE("the newest entry of both changelogs is the version of the project") {
  REQUIRE_FALSE(version_of_project().empty());
  CHECK(first_in("CHANGELOG.md", R"(^## \[(\d+\.\d+\.\d+)\] - \d{4}-\d\d-\d\d$)") == version_of_project());
  CHECK(first_in("engine/stepwire/package/changelog", R"(^stepwire \((\S+)\) )") == version_of_project());
}

TEST_CASE("no package of node in the tree has a version of its own") {
  std::size_t packages = 0;
  for (const std::string& file : files_under("")) {
    const bool is_lock = file.ends_with("package-lock.json");
    if (!is_lock && !file.ends_with("/package.json")) continue;
    INFO(file << ": a private package needs no version");
    const nlohmann::json package = read(file);
    CHECK_FALSE(package.contains("version"));
    if (is_lock) CHECK_FALSE(package.at("packages").at("").contains("version"));
    ++packages;
  }
  CHECK(packages > 4);
}

TEST_CASE("no source, script or list of the build repeats the version of the project") {
  const std::string version = version_of_project();
  for (const std::string folder : {"engine", "blocks", "tests", "bench"})
    for (const std::string& file : files_under(folder)) {
      const std::string ending = std::filesystem::path(file).extension();
      if (ending != ".cpp" && ending != ".hpp" && ending != ".py" && ending != ".cmake" && ending != ".txt" &&
          ending != ".mjs" && ending != ".ts" && ending != ".md")
        continue;
      for (const Line& line : lines_of(file))
        if (line.text.find("stepwire " + version) != std::string::npos ||
            line.text.find("\"" + version + "\"") != std::string::npos)
          FAIL_CHECK(line.place() << ": " << line.text);
    }
}
