#include "engine/base/subprocess/scratch_folder.hpp"

#include <sys/wait.h>

#include <catch2/catch.hpp>
#include <cstdlib>

#include "tests/engine/base/table/scratch.hpp"

namespace stepwire::subprocess {

namespace {

/// A process that is killed while it has a scratch folder with a file.
void leave_folder() {
  const pid_t child = ::fork();
  if (child == 0) {
    const ScratchFolder folder;
    std::ofstream(folder.path() + "/program.cpp") << "int main() {}";
    ::raise(SIGKILL);
  }
  ::waitpid(child, nullptr, 0);
}

}  // namespace

TEST_CASE("The folder of a process that was killed is removed, and one in use or of another name stays") {
  const Scratch temporary;
  const char* given = std::getenv("TMPDIR");
  const std::string before = given ? given : "";
  ::setenv("TMPDIR", temporary.path("").c_str(), 1);
  {
    leave_folder();
    const ScratchFolder used;
    std::filesystem::create_directory(temporary.path("stepwire-work-own"));
    CHECK(temporary.files() == 3);
    remove_abandoned_folders();
    CHECK(temporary.files() == 2);
    CHECK(std::filesystem::exists(used.path()));
    CHECK(std::filesystem::exists(temporary.path("stepwire-work-own")));
  }
  CHECK(temporary.files() == 1);
  before.empty() ? ::unsetenv("TMPDIR") : ::setenv("TMPDIR", before.c_str(), 1);
}

TEST_CASE("A link with the name of a scratch folder is left alone") {
  const Scratch temporary, other;
  other.file("own.txt", "stays");
  std::filesystem::create_directory_symlink(other.path(""), temporary.path("stepwire-work-aaaaaa"));
  ::setenv("TMPDIR", temporary.path("").c_str(), 1);
  remove_abandoned_folders();
  ::unsetenv("TMPDIR");
  CHECK(std::filesystem::exists(other.path("own.txt")));
}

}  // namespace stepwire::subprocess
