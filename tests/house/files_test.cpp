#include <catch2/catch.hpp>
#include <cctype>
#include <set>
#include <string>
#include <vector>

#include "tests/house/source_tree.hpp"

namespace {

constexpr std::size_t max_lines = 600;

// Put together, so that this file does not hold them.
const std::vector<std::string> private_places{std::string("/ho") + "me/", std::string("/ro") + "ot/",
                                              std::string("/wo") + "rk/"};

// Only where a path starts: a folder of the project may have such a name.
bool holds_path(const std::string& text, const std::string& place) {
  for (auto at = text.find(place); at != std::string::npos; at = text.find(place, at + 1)) {
    const unsigned char before = at == 0 ? ' ' : static_cast<unsigned char>(text[at - 1]);
    if (!std::isalnum(before) && std::string("._-}").find(static_cast<char>(before)) == std::string::npos)
      return true;
  }
  return false;
}

}  // namespace

TEST_CASE("no source has more lines than one can keep in mind") {
  std::set<std::string> endings;
  for (const std::string& file : all_sources_under({"engine", "blocks", "tests", "bench", "diagrams"})) {
    INFO(file);
    CHECK(lines_of(file).size() <= max_lines);
    endings.insert(std::filesystem::path(file).extension().string());
  }
  CHECK(endings == std::set<std::string>{".cpp", ".hpp", ".mjs", ".py", ".ts"});
}

TEST_CASE("no file speaks of the places of one machine") {
  for (const std::string& file : files_under(""))
    for (const Line& line : lines_of(file))
      for (const std::string& place : private_places)
        if (holds_path(line.text, place)) FAIL_CHECK(line.place() << ": " << line.text);
}

TEST_CASE("a path is told from a part of one") {
  const std::string& place = private_places.front();
  CHECK(holds_path("cd " + place + "me", place));
  CHECK(holds_path(place, place));
  CHECK_FALSE(holds_path("https://example.org" + place, place));
  CHECK_FALSE(holds_path("diagrams" + place + "a.yaml", place));
}
