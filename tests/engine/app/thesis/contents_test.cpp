#include <catch2/catch.hpp>
#include <filesystem>

#include "engine/app/thesis/thesis_contents.hpp"
#include "engine/base/io/file.hpp"
#include "engine/base/yaml/error.hpp"
#include "tests/engine/app/cli/program.hpp"

using Catch::Contains;

namespace stepwire::thesis {
namespace {

ThesisContents contents_of(const Scratch& folder, const std::string& text) {
  std::filesystem::create_directories(folder.path("gallery"));
  io::write_file(folder.path("gallery/contents.yaml"), text);
  return read_contents(folder.path("."));
}

std::string complaint_of(const Scratch& folder, const std::string& text) try {
  contents_of(folder, text);
  return "";
} catch (const yaml::Error& error) {
  return error.what();
}

gallery::GalleryEntry entry(std::optional<int> figure, std::optional<int> table) {
  gallery::GalleryEntry result{};
  result.figure = figure;
  result.table = table;
  return result;
}

}  // namespace

TEST_CASE("tables stand behind the figures that the contents name, what is not named comes last") {
  const Scratch folder;
  const ThesisContents contents = contents_of(folder, "title: T\ntables: {7: 3, 8: 3}\n");
  CHECK(contents.place_of(entry(3, {})) < contents.place_of(entry({}, 7)));
  CHECK(contents.place_of(entry({}, 7)) < contents.place_of(entry({}, 8)));
  CHECK(contents.place_of(entry({}, 8)) < contents.place_of(entry(4, {})));
  CHECK(contents.place_of(entry(1000, {})) < contents.place_of(entry({}, 9)));
}

TEST_CASE("contents with a fault are refused at its place") {
  const Scratch folder;
  CHECK_THAT(complaint_of(folder, "introduction: T\n"), Contains("'title' is missing"));
  CHECK_THAT(complaint_of(folder, "title: T\ntables: {a: 3}\n"),
             Contains("contents.yaml:2:10: tables: has whole numbers"));
  CHECK_THAT(complaint_of(folder, "title: T\nsummaries: [{chapter: 4, title: S}]\n"),
             Contains("contents.yaml:2:13: summaries: 'sentences' is missing"));
  CHECK_THAT(complaint_of(folder, "title: T\nsumaries: []\n"), Contains("summaries"));
}

TEST_CASE("a folder without contents is refused by the name of the file that is missing") {
  const Scratch folder;
  CHECK_THROWS_WITH(read_contents(folder.path(".")), Contains("gallery/contents.yaml"));
}

}  // namespace stepwire::thesis
