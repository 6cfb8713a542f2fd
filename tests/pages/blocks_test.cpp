// Statements of the pages about blocks.
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>

#include "tests/pages/page.hpp"
#include "tests/pages/workbench.hpp"

namespace {

std::string text_of(const std::string& file) {
  return content_of(std::filesystem::path(STEPWIRE_SOURCE_DIR) / file);
}

struct Library {
  std::set<std::string> blocks, families;
};

Library library() {
  Library all;
  for (const auto& block : nlohmann::json::parse(printed_by_program("blocks --json"))) {
    all.blocks.insert(block.at("name").get<std::string>());
    all.families.insert(block.at("folder").get<std::string>());
  }
  return all;
}

/// The lines of the table below this heading.
std::string table_below(const std::string& page, const std::string& heading) {
  const std::size_t begin = page.find(heading);
  REQUIRE(begin != std::string::npos);
  return page.substr(begin, page.find("\n\n", begin) - begin);
}

}  // namespace

TEST_CASE("the page on blocks shows the files of its example as they are") {
  const std::string page = text_of("blocks/README.md");
  for (const std::string file : {"blocks/math/gain.hpp", "blocks/math/gain.cpp"}) {
    INFO(file);
    CHECK(page.find("```cpp\n" + text_of(file) + "```\n") != std::string::npos);
  }
}

TEST_CASE("every block that is offered for one of Simulink's is there") {
  const std::string table = table_below(text_of("README.md"), "| Simulink | here |");
  const Library all = library();
  const std::regex pascal("`([A-Z][A-Za-z0-9]*)`");
  std::size_t found = 0;
  for (std::sregex_iterator block(table.begin(), table.end(), pascal), none; block != none;
       ++block, ++found) {
    INFO(block->str(1));
    CHECK(all.blocks.contains(block->str(1)));
  }
  CHECK(found > 20);
}

TEST_CASE("the page on blocks names every family") {
  const std::string page = text_of("blocks/README.md");
  for (const std::string& family : library().families) {
    INFO(family);
    CHECK(page.find("| `" + family + "` |") != std::string::npos);
  }
}
