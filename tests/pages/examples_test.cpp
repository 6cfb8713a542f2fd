// The page of the examples lists each file with its title, and what it is about is in the file.
#include <algorithm>
#include <catch2/catch.hpp>
#include <filesystem>
#include <sstream>

#include "engine/base/io/file.hpp"
#include "engine/base/text/natural_order.hpp"
#include "engine/base/yaml/document.hpp"
#include "tests/pages/page.hpp"

namespace {

const std::string folder = "diagrams/examples";

std::vector<std::string> examples() {
  std::vector<std::string> files;
  for (const auto& entry :
       std::filesystem::directory_iterator(std::filesystem::path(STEPWIRE_SOURCE_DIR) / folder))
    if (entry.path().extension() == ".yaml") files.push_back(entry.path().filename().string());
  std::ranges::sort(files, stepwire::text::naturally_less);
  return files;
}

/// "| [01](01-first.yaml) | A title |": the row of a file as far as it follows from it.
std::string row_of(const std::string& file) {
  const auto document =
      stepwire::yaml::read_document(std::string(STEPWIRE_SOURCE_DIR) + "/" + folder + "/" + file);
  const stepwire::yaml::Node* title = document.root.find("title");
  return "| [" + file.substr(0, file.find('-')) + "](" + file + ") | " + (title ? title->text : "") + " |";
}

std::vector<std::string> rows() {
  std::vector<std::string> all;
  for (const Line& line : lines_of(folder + "/README.md"))
    if (line.text.starts_with("| [")) all.push_back(line.text);
  return all;
}

}  // namespace

TEST_CASE("the page of the examples lists all of them by their numbers, with their titles") {
  const std::vector<std::string> files = examples(), listed = rows();
  REQUIRE(listed.size() == files.size());
  for (std::size_t i = 0; i < files.size(); ++i) {
    INFO(listed[i]);
    CHECK(listed[i].starts_with(row_of(files[i])));
  }
}

TEST_CASE("what the page of the examples says that a file is about stands in the file") {
  const std::vector<std::string> files = examples(), listed = rows();
  for (std::size_t i = 0; i < std::min(files.size(), listed.size()); ++i) {
    const std::string text =
        stepwire::io::read_file(std::string(STEPWIRE_SOURCE_DIR) + "/" + folder + "/" + files[i]);
    const std::vector<std::string> about = code_in(listed[i]);
    INFO(listed[i]);
    CHECK_FALSE(about.empty());
    for (const std::string& word : about) CHECK(text.find(word) != std::string::npos);
  }
}
