#include <catch2/catch.hpp>
#include <regex>
#include <set>

#include "tests/pages/page.hpp"
#include "tests/pages/workbench.hpp"

namespace {

/// The rows of the table of rooms: "base/io" of "| `base/io` | ...".
std::set<std::string> rooms_in(const std::string& page) {
  std::set<std::string> rooms;
  const std::regex row(R"(\n\| `(\w+(?:/\w+)*)` \|)");
  for (std::sregex_iterator at(page.begin(), page.end(), row), none; at != none; ++at)
    rooms.insert(at->str(1));
  return rooms;
}

}  // namespace

TEST_CASE("the page on the engine has a row for each of its rooms, and for no other") {
  std::set<std::string> rooms;
  for (const std::string& file : sources_under({"engine"}))
    rooms.insert(folder_of(file).substr(std::string("engine/").size()));
  CHECK(rooms_in(content_of(std::filesystem::path(STEPWIRE_SOURCE_DIR) / "engine/README.md")) == rooms);
}
