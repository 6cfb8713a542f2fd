#include <catch2/catch.hpp>
#include <map>
#include <regex>

#include "tests/house/source_tree.hpp"

TEST_CASE("no two headers define a type of one name") {
  // The linker would take one of them for both, and nobody would say so.
  const std::regex definition(R"(^(?:struct|class) ([A-Z]\w*)(?: final)?(?: :.*)?(?: \{.*)?$)");
  std::map<std::string, std::string> first;
  for (const std::string& file : sources_under({"engine", "blocks"})) {
    if (!file.ends_with(".hpp")) continue;
    for (const Line& line : lines_of(file)) {
      std::smatch match;
      if (!std::regex_match(line.text, match, definition)) continue;
      const auto [known, is_new] = first.emplace(match[1], file);
      INFO(line.place() << ": " << line.text << "; also in " << known->second);
      CHECK((is_new || known->second == file));
    }
  }
  CHECK(first.size() > 100);
}
