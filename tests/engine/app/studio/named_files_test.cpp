#include "engine/app/studio/named_files.hpp"

#include <catch2/catch.hpp>
#include <cstdlib>
#include <filesystem>

#include "tests/engine/app/cli/program.hpp"

namespace stepwire::studio {

namespace {

namespace fs = std::filesystem;

/// Returns the files that a text in a folder "home" names, as paths from the folder above.
std::vector<std::string> named(const Scratch& folder, const std::string& text) {
  std::vector<std::string> names;
  for (const NamedFile& one : named_files(yaml::parse_document(text, folder.path("home/a.yaml")))) {
    const std::string name = fs::path(one.path).lexically_relative(folder.path("")).string();
    names.push_back(name + (one.is_diagram ? " diagram" : "") + (one.is_plain ? "" : " astray"));
  }
  return names;
}

}  // namespace

TEST_CASE("whatever value of a diagram names a file is found, wherever it stands and however it is written") {
  const Scratch folder;
  fs::create_directories(folder.path("home/deep"));
  folder.file("home/x.csv", "");
  folder.file("home/part.yaml", "");
  folder.file("home/part.txt", "");
  folder.file("other.csv", "");
  using Names = std::vector<std::string>;
  CHECK(named(folder, "title: nothing\nblocks: {a: {block: Gain, u: 1, deep: deep}}\n").empty());
  CHECK(named(folder, "a: {b: [1, [{c: x.csv}]]}") == Names{"home/x.csv"});
  CHECK(named(folder, "a: \"x.csv\"\nb: './x.csv'\nc: deep/../x.csv\n") ==
        Names{"home/x.csv", "home/x.csv", "home/x.csv"});
  CHECK(named(folder, "a: ../other.csv") == Names{"other.csv"});
  CHECK(named(folder, "a: " + folder.path("other.csv")) == Names{"other.csv"});
  CHECK(named(folder, "a: part.yaml\ndiagram: part.txt\n") ==
        Names{"home/part.yaml diagram", "home/part.txt diagram"});
  CHECK(named(folder, "a: &x x.csv\nb: *x\n") == Names{"home/x.csv", "home/x.csv"});
}

TEST_CASE("a path that a link turns elsewhere than it says is known as such") {
  const Scratch folder;
  fs::create_directories(folder.path("home"));
  fs::create_directories(folder.path("far/away"));
  folder.file("home/x.csv", "");
  folder.file("far/x.csv", "");
  fs::create_directory_symlink(folder.path("far/away"), folder.path("home/link"));
  CHECK(named(folder, "a: link/../x.csv") == std::vector<std::string>{"home/x.csv astray"});
}

}  // namespace stepwire::studio
