#include <unistd.h>

#include <catch2/catch.hpp>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "engine/base/yaml/document.hpp"

namespace stepwire::yaml {

namespace {

/// A folder that goes away with the test.
class Folder {
 public:
  Folder() {
    std::string name = (std::filesystem::temp_directory_path() / "stepwire-XXXXXX").string();
    REQUIRE(mkdtemp(name.data()) != nullptr);
    path_ = name;
  }
  ~Folder() { std::filesystem::remove_all(path_); }
  std::string operator/(const std::string& name) const { return path_ / name; }

 private:
  std::filesystem::path path_;
};

}  // namespace

TEST_CASE("a file is read and keeps its name as it was given") {
  const Folder folder;
  std::ofstream(folder / "a.yaml") << "a: 1\n";
  const Document document = read_document(folder / "a.yaml");
  CHECK(document.file == folder / "a.yaml");
  CHECK(document.root.find("a")->text == "1");
}

TEST_CASE("a missing file and a folder are errors of the whole file") {
  const Folder folder;
  const std::string missing = folder / "b.yaml", here = folder / "";
  CHECK_THROWS_WITH(read_document(missing), missing + ": no such file");
  CHECK_THROWS_WITH(read_document(here), here + ": this is a folder, not a file");
  CHECK_THROWS_AS(read_document(""), Error);
}

TEST_CASE("a file without permission is an error that says so") {
  if (geteuid() == 0) return;  // nothing is unreadable for the superuser
  const Folder folder;
  const std::string path = folder / "a.yaml";
  std::ofstream(path) << "a: 1\n";
  std::filesystem::permissions(path, std::filesystem::perms::none);
  CHECK_THROWS_WITH(read_document(path), path + ": cannot be read: Permission denied");
}

TEST_CASE("a file above 8 MB is refused by its size, unless the limit is raised") {
  const Folder folder;
  const std::string path = folder / "a.yaml";
  std::ofstream(path) << "a: 1\n";
  std::filesystem::resize_file(path, 9u << 20);  // NUL bytes, which reading would complain about
  CHECK_THROWS_WITH(read_document(path), path + ": the file has 9.0 MB, and at most 8.0 MB are read");
  DocumentLimits limits;
  limits.bytes = 16u << 20;
  CHECK_THROWS_WITH(read_document(path, limits), Catch::StartsWith(path + ":2:1: a NUL byte"));
}

TEST_CASE("a device without end is read up to the limit only") {
  DocumentLimits limits;
  limits.bytes = 1 << 20;
  CHECK_THROWS_WITH(read_document("/dev/zero", limits), Catch::Contains("no regular file"));
}

}  // namespace stepwire::yaml
