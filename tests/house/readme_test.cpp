#include <catch2/catch.hpp>

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
