#include <algorithm>
#include <catch2/catch.hpp>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include "tests/house/source_tree.hpp"

namespace {

using Folders = std::set<std::string>;

/// The floors, from below.
const std::vector<std::string> floors{"base",    "drivers",  "model", "simulate",
                                      "analyse", "stepwire", "view",  "app"};

std::string floor_of(const std::string& room) {
  return room.substr(0, room.find('/'));
}

std::ptrdiff_t height_of(const std::string& room) {
  return std::find(floors.begin(), floors.end(), floor_of(room)) - floors.begin();
}

/// Returns the rooms that the library of each room links, by engine/CMakeLists.txt.
std::map<std::string, Folders> links() {
  std::string text;
  for (const Line& line : lines_of("engine/CMakeLists.txt")) text += line.text + "\n";
  const std::regex library(R"re(stepwire_(?:library|driver)\(engine/(\w+(?:/\w+)*)([^)]*)\))re"),
      link(R"re(engine_\w+)re");
  const std::sregex_iterator begin(text.begin(), text.end(), library), end;
  std::map<std::string, std::string> rooms;  // "base/io" of a link to "engine_base_io"
  for (auto it = begin; it != end; ++it)
    rooms[std::regex_replace("engine/" + it->str(1), std::regex("/"), "_")] = it->str(1);
  std::map<std::string, Folders> found;
  for (auto it = begin; it != end; ++it) {
    Folders& linked = found[it->str(1)];
    const std::string rest = it->str(2);
    for (std::sregex_iterator one(rest.begin(), rest.end(), link); one != end; ++one)
      linked.insert(rooms.contains(one->str()) ? rooms.at(one->str()) : one->str());
  }
  return found;
}

// They are transitive: who may see a room may see what it sees.
const std::map<std::string, Folders>& arrows() {
  static const std::map<std::string, Folders> all = links();
  return all;
}

const Folders seen_by_blocks{"model/signal",   "model/block", "base/expression", "base/table", "base/io",
                             "base/data_file", "base/unit",   "base/math",       "base/text"};

void reach(const std::string& folder, Folders& seen) {
  if (!seen.insert(folder).second || !arrows().contains(folder)) return;
  for (const std::string& next : arrows().at(folder)) reach(next, seen);
}

Folders reachable_from(const std::string& folder) {
  Folders seen;
  reach(folder, seen);
  return seen;
}

// A family of blocks sees itself. The folder that registers all blocks sees the families and their library.
// The preparation of records has a room of its own, which suggests names as the reader of diagrams does.
bool block_may_include(const std::string& file, const std::string& included) {
  const std::string folder = folder_of(file);
  const bool reads_files = folder == "blocks/records" || folder == "blocks/sources";
  if (reads_files && included == "engine/base/yaml") return true;
  if (folder == "blocks/sources" && included == "blocks/records") return true;
  if (folder == "blocks/cosimulation" && included == "engine/base/fmi") return true;
  if (folder == "blocks/haptics" && included == "blocks/haptics/region") return true;
  if (folder == "blocks" && included == "engine/stepwire") return true;
  if (included.starts_with("engine/")) return seen_by_blocks.contains(included.substr(7));
  return included == folder_of(file) || folder_of(file) == "blocks";
}

bool engine_may_include(const std::string& file, const std::string& included) {
  const bool brings_together = file == "engine/app/cli/main.cpp" || file == "engine/app/python/main.cpp";
  if (brings_together && included.starts_with("blocks")) return true;
  return included.starts_with("engine/") &&
         reachable_from(folder_of(file).substr(7)).contains(included.substr(7));
}

}  // namespace

TEST_CASE("every room of the engine has a library") {
  REQUIRE(arrows().size() > 30);
  for (const std::string& file : sources_under({"engine"})) {
    INFO(file);
    CHECK(arrows().contains(folder_of(file).substr(7)));
  }
}

TEST_CASE("no arrow leads back") {
  for (const auto& [folder, targets] : arrows())
    for (const std::string& target : targets) {
      INFO(folder << " -> " << target);
      CHECK(arrows().contains(target));
      CHECK_FALSE(reachable_from(target).contains(folder));
    }
}

TEST_CASE("a room links rooms of its own floor and of floors below") {
  for (const auto& [room, targets] : arrows()) {
    REQUIRE(height_of(room) < std::ssize(floors));
    for (const std::string& target : targets) {
      INFO(room << " -> " << target);
      CHECK(height_of(target) <= height_of(room));
    }
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
