#include <algorithm>
#include <catch2/catch.hpp>
#include <map>
#include <regex>
#include <set>

#include "tests/house/source_tree.hpp"

namespace {

using Folders = std::set<std::string>;

// The arrows of the architecture inside engine/. They are transitive: who may see a folder may see what it
// sees.
const std::map<std::string, Folders> arrows{
    {"base", {}},
    {"signal", {}},
    {"block", {"signal"}},
    {"unit", {}},
    {"expression", {"signal", "unit"}},
    {"table", {"signal", "base"}},
    {"document", {"base"}},
    {"diagram", {"block", "document", "expression", "table", "unit"}},
    {"process", {"table"}},
    {"draw", {"diagram", "process"}},
    {"plan", {"diagram"}},
    {"solve", {"plan"}},
    {"record", {"plan", "table"}},
    {"run", {"solve", "record"}},
    {"replay", {"run"}},
    {"statistics", {}},
    {"figure", {"diagram", "draw", "process", "record", "expression", "statistics"}},
    {"realtime", {"run", "process"}},
    {"generate", {"solve", "record", "process"}},
    {"identify", {"run", "figure", "statistics"}},
    {"study", {"run", "figure", "statistics"}},
    {"describe", {"diagram", "table", "figure", "solve"}},
    {"cli", {"run", "replay", "draw", "figure", "describe", "realtime", "generate", "identify", "study"}},
};

const Folders seen_by_blocks{"signal", "block", "expression", "table", "unit"};

void reach(const std::string& folder, Folders& seen) {
  if (!seen.insert(folder).second || !arrows.contains(folder)) return;
  for (const std::string& next : arrows.at(folder)) reach(next, seen);
}

Folders reachable_from(const std::string& folder) {
  Folders seen;
  reach(folder, seen);
  return seen;
}

// A family of blocks sees itself; the file that registers them all sees the families. What is done to a
// record has a room of its own, which suggests names as the reader of diagrams does.
bool block_may_include(const std::string& file, const std::string& included) {
  const std::string folder = folder_of(file);
  if (folder == "blocks/records" && included == "engine/document") return true;
  if (folder == "blocks/sources" && included == "blocks/records") return true;
  if (included.starts_with("engine/")) return seen_by_blocks.contains(included.substr(7));
  return included == folder_of(file) || folder_of(file) == "blocks";
}

bool engine_may_include(const std::string& file, const std::string& included) {
  if (file == "engine/cli/main.cpp" && included.starts_with("blocks")) return true;
  return included.starts_with("engine/") &&
         reachable_from(folder_of(file).substr(7)).contains(included.substr(7));
}

}  // namespace

TEST_CASE("every folder of the engine stands in the table of arrows") {
  for (const std::string& file : sources_under({"engine"})) {
    INFO(file);
    CHECK(arrows.contains(folder_of(file).substr(7)));
  }
}

TEST_CASE("no arrow leads back") {
  for (const auto& [folder, targets] : arrows)
    for (const std::string& target : targets) {
      INFO(folder << " -> " << target);
      CHECK(arrows.contains(target));
      CHECK_FALSE(reachable_from(target).contains(folder));
    }
}

TEST_CASE("what a file includes follows the arrows") {
  const std::regex include(R"re(^\s*#\s*include\s*"((?:engine|blocks|tests|bench)/[^"]*)")re");
  for (const std::string& file : sources_under({"engine", "blocks"}))
    for (const Line& line : lines_of(file)) {
      std::smatch match;
      if (!std::regex_search(line.text, match, include)) continue;
      INFO(line.place() << ": " << line.text);
      const std::string included = folder_of(match[1]);
      CHECK((file.starts_with("blocks/") ? block_may_include(file, included)
                                         : engine_may_include(file, included)));
    }
}

TEST_CASE("our own headers are included by their path from the top") {
  const std::regex quoted(R"re(^\s*#\s*include\s*"([^"]*)")re");
  for (const std::string& file : sources_under({"engine", "blocks"}))
    for (const Line& line : lines_of(file)) {
      std::smatch match;
      if (!std::regex_search(line.text, match, quoted)) continue;
      INFO(line.place() << ": " << line.text);
      const std::string path = match[1];
      CHECK((path.starts_with("engine/") || path.starts_with("blocks/")));
    }
}
