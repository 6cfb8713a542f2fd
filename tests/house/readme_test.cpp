#include <catch2/catch.hpp>
#include <regex>

#include "tests/house/source_tree.hpp"

namespace {

std::string text_of(const std::string& file) {
  std::string text;
  for (const Line& line : lines_of(file)) text += line.text + "\n";
  return text;
}

}  // namespace

TEST_CASE("the README shows the files of its example block as they are") {
  const std::string readme = text_of("README.md");
  for (const std::string file : {"blocks/continuous/lag.hpp", "blocks/continuous/lag.cpp"}) {
    INFO(file);
    CHECK(readme.find("```cpp\n" + text_of(file) + "```\n") != std::string::npos);
  }
}

TEST_CASE("every block that the README offers for one of Simulink's is there") {
  std::string library;
  for (const std::string folder :
       {"continuous", "discrete", "logic", "math", "nonlinear", "routing", "sinks", "sources"})
    library += text_of("blocks/" + folder + "/register.cpp");
  const std::string readme = text_of("README.md");
  const std::size_t begin = readme.find("| Simulink | here |"), end = readme.find("## Command line");
  REQUIRE(begin < end);
  const std::regex pascal("`([A-Z][A-Za-z0-9]*)`");
  const std::string table = readme.substr(begin, end - begin);
  for (std::sregex_iterator block(table.begin(), table.end(), pascal), none; block != none; ++block) {
    INFO(block->str(1));
    const bool there = library.find("add<" + block->str(1) + ">") != std::string::npos ||
                       library.find("add<" + block->str(1) + "Block>") != std::string::npos;
    CHECK(there);
  }
}
