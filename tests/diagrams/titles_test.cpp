#include <catch2/catch.hpp>
#include <filesystem>
#include <regex>
#include <sstream>

#include "engine/base/io/file.hpp"

namespace stepwire {

TEST_CASE("no title of a picture says how often a study is made, which the call may say, too") {
  const std::regex counted(R"(\btitle: [^,}]*\b([0-9]+|ten|twenty) experiments)");
  for (const char* folder : {"examples", "thesis"})
    for (const auto& entry : std::filesystem::directory_iterator(std::filesystem::path(STEPWIRE_SOURCE_DIR) /
                                                                 "diagrams" / folder)) {
      if (entry.path().extension() != ".yaml") continue;
      std::istringstream lines(io::read_file(entry.path().string()));
      for (std::string line; std::getline(lines, line);) {
        INFO(entry.path() << ": " << line);
        CHECK_FALSE(std::regex_search(line, counted));
      }
    }
}

TEST_CASE("the page of the thesis lists each file with its title") {
  const std::filesystem::path folder = std::filesystem::path(STEPWIRE_SOURCE_DIR) / "diagrams/thesis";
  const std::string page = io::read_file((folder / "README.md").string());
  std::size_t files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() != ".yaml") continue;
    const std::string name = entry.path().filename().string(), text = io::read_file(entry.path().string());
    std::smatch title;
    REQUIRE(std::regex_search(text, title, std::regex("\\ntitle: \"?([^\"\n]*)")));
    INFO(name);
    CHECK(page.find("[" + name + "](" + name + ") | " + title.str(1) + " |") != std::string::npos);
    ++files;
  }
  CHECK(files == 52);
}

}  // namespace stepwire
