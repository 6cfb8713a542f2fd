#include "engine/base/io/inside.hpp"

#include <catch2/catch.hpp>
#include <cstdlib>
#include <filesystem>

#include "engine/base/io/environment_error.hpp"
#include "engine/base/io/file.hpp"
#include "engine/base/yaml/document.hpp"
#include "engine/base/yaml/error.hpp"
#include "tests/engine/base/table/scratch.hpp"

using namespace stepwire;

TEST_CASE("a path is below a folder by its canonical form") {
  const Scratch folder, other;
  folder.file("a.txt", "");
  other.file("b.txt", "");
  std::filesystem::create_symlink(other.path("b.txt"), folder.path("link"));
  std::filesystem::create_symlink(folder.path(""), other.path("back"));
  CHECK(io::is_below(folder.path("a.txt"), folder.path("")));
  CHECK(io::is_below(folder.path("new/file"), folder.path("")));
  CHECK(io::is_below(folder.path("x/../a.txt"), folder.path("")));
  CHECK(io::is_below(other.path("back/a.txt"), folder.path("")));
  CHECK_FALSE(io::is_below(folder.path("link"), folder.path("")));
  CHECK_FALSE(io::is_below(folder.path("../a.txt"), folder.path("")));

  CHECK(io::is_below("/etc/passwd", "/"));
}

TEST_CASE("readers refuse files outside of the folders of STEPWIRE_INSIDE") {
  const Scratch inside, outside;
  inside.file("a.yaml", "a: 1\n");
  outside.file("a.yaml", "a: 1\n");
  const char* const known = std::getenv("TMPDIR");
  const std::string temporary = known ? known : "";
  ::setenv("TMPDIR", inside.path("").c_str(), 1);  // temporary files are always readable
  ::setenv(io::inside_variable, inside.path("").c_str(), 1);
  CHECK(io::read_file(inside.path("a.yaml")) == "a: 1\n");
  CHECK_THROWS_AS(io::read_file(outside.path("a.yaml")), io::EnvironmentError);
  CHECK(yaml::read_document(inside.path("a.yaml")).root.is_map());
  CHECK_THROWS_AS(yaml::read_document(outside.path("a.yaml")), yaml::Error);
  ::unsetenv(io::inside_variable);
  known ? ::setenv("TMPDIR", temporary.c_str(), 1) : ::unsetenv("TMPDIR");
  CHECK(io::read_file(outside.path("a.yaml")) == "a: 1\n");
}
