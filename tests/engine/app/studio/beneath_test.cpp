#include "engine/app/studio/beneath.hpp"

#include <sys/stat.h>
#include <unistd.h>

#include <catch2/catch.hpp>
#include <filesystem>

#include "engine/app/studio/fault.hpp"
#include "tests/engine/app/cli/program.hpp"

namespace stepwire::studio {

namespace {

namespace fs = std::filesystem;
using Catch::Contains;

/// A folder that is open to pages, beside one that is not.
struct Folders {
  Folders() {
    fs::create_directories(scratch.path("open/sub"));
    fs::create_directories(scratch.path("secret"));
    scratch.file("open/a.yaml", "a");
    scratch.file("open/sub/b.yaml", "b");
    scratch.file("secret/s.yaml", "s");
    beneath.add(scratch.path("open"));
  }
  std::string path(const std::string& name) const { return scratch.path(name); }
  bool reads(const std::string& name) const {
    try {
      return !beneath.read(path(name)).text.empty();
    } catch (const Fault&) {
      return false;
    }
  }

  Scratch scratch;
  Beneath beneath;
};

mode_t mode_of(const std::string& path) {
  struct stat status {};
  ::stat(path.c_str(), &status);
  return status.st_mode & 07777u;
}

}  // namespace

TEST_CASE("files beneath the folders are read, and nothing else") {
  const Folders folders;
  CHECK(folders.reads("open/a.yaml"));
  CHECK(folders.reads("open/sub/b.yaml"));
  for (const std::string& name :
       std::vector<std::string>{"secret/s.yaml", "open/../secret/s.yaml", "open/sub/../../secret/s.yaml",
                                "open", "open/sub", "open/none", "openly", "open/a.yaml/b"}) {
    INFO(name);
    CHECK_FALSE(folders.reads(name));
    CHECK_THROWS_AS(folders.beneath.replace(folders.path(name), "x"), Fault);
  }
  CHECK_THROWS_AS(folders.beneath.read("/etc/passwd"), Fault);
  CHECK_THROWS_AS(folders.beneath.read("open/a.yaml"), Fault);
  CHECK_THROWS_AS(folders.beneath.read(""), Fault);
  CHECK(content_of(folders.path("secret/s.yaml")) == "s");
}

TEST_CASE("a link that leads out is refused, whatever part of the path it is; one that stays is followed") {
  const Folders folders;
  fs::create_symlink(folders.path("secret/s.yaml"), folders.path("open/out.yaml"));
  fs::create_symlink("../secret", folders.path("open/folder"));
  fs::create_symlink("/etc", folders.path("open/etc"));
  fs::create_symlink("a.yaml", folders.path("open/in.yaml"));
  fs::create_symlink("loop.yaml", folders.path("open/loop.yaml"));
  for (const std::string& name :
       std::vector<std::string>{"open/out.yaml", "open/folder/s.yaml", "open/etc/passwd", "open/loop.yaml"}) {
    INFO(name);
    CHECK_FALSE(folders.reads(name));
    CHECK_FALSE(folders.beneath.is_writable(folders.path(name)));
    CHECK_THROWS_AS(folders.beneath.replace(folders.path(name), "x"), Fault);
    CHECK_THROWS_AS(folders.beneath.create(folders.path(name), "x"), Fault);
  }
  CHECK_THROWS_WITH(folders.beneath.read(folders.path("open/out.yaml")),
                    Contains("leads out of the folders"));
  CHECK(folders.reads("open/in.yaml"));
  CHECK_THROWS_AS(folders.beneath.replace(folders.path("open/in.yaml"), "x"),
                  Fault);  // it would be a link no more
  CHECK(content_of(folders.path("secret/s.yaml")) == "s");
  CHECK(content_of(folders.path("open/a.yaml")) == "a");
}

TEST_CASE("pipes and devices are no files") {
  const Folders folders;
  REQUIRE(::mkfifo(folders.path("open/pipe.yaml").c_str(), 0600) == 0);
  CHECK_FALSE(folders.reads("open/pipe.yaml"));
  CHECK_THROWS_AS(folders.beneath.replace(folders.path("open/pipe.yaml"), "x"), Fault);
}

TEST_CASE("what is written takes the place of the file with its mode, and leaves nothing else") {
  const Folders folders;
  const std::string path = folders.path("open/a.yaml");
  for (const mode_t mode : {0600u, 0644u, 0640u, 0755u}) {
    ::chmod(path.c_str(), mode);
    folders.beneath.replace(path, "text " + std::to_string(mode));
    CHECK(content_of(path) == "text " + std::to_string(mode));
    CHECK(mode_of(path) == mode);
  }
  CHECK(std::distance(fs::directory_iterator(folders.path("open")), {}) == 2);
}

TEST_CASE("a new file takes no file's place") {
  const Folders folders;
  folders.beneath.create(folders.path("open/new.yaml"), "new");
  CHECK(content_of(folders.path("open/new.yaml")) == "new");
  CHECK_THROWS_AS(folders.beneath.create(folders.path("open/a.yaml"), "new"), Fault);
  CHECK_THROWS_AS(folders.beneath.create(folders.path("secret/new.yaml"), "new"), Fault);
  CHECK(content_of(folders.path("open/a.yaml")) == "a");
}

TEST_CASE("a folder that is exchanged for a link later leads nowhere else") {
  const Folders folders;
  fs::rename(folders.path("open/sub"), folders.path("open/was"));
  fs::create_symlink(folders.path("secret"), folders.path("open/sub"));
  CHECK_FALSE(folders.reads("open/sub/s.yaml"));
  fs::rename(folders.path("open"), folders.path("moved"));
  fs::create_symlink(folders.path("secret"), folders.path("open"));
  CHECK_FALSE(folders.reads("open/s.yaml"));  // the folder is known by itself, not by its name
  CHECK(folders.reads("open/a.yaml"));
}

}  // namespace stepwire::studio
