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

}  // namespace stepwire
