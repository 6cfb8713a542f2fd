#include "engine/base/io/owned_folder.hpp"

#include <catch2/catch.hpp>
#include <optional>

#include "engine/base/io/atomic_file_writer.hpp"
#include "engine/base/io/file.hpp"
#include "tests/engine/base/table/scratch.hpp"

namespace stepwire::io {
using Catch::Contains;

namespace {

bool there(const Scratch& folder, const std::string& name) {
  return std::filesystem::exists(folder.path(name));
}

}  // namespace

TEST_CASE("A folder that one run owns is refused to another until the first has ended") {
  const Scratch folder;
  {
    const OwnedFolder own(folder.path("out"));
    CHECK_THROWS_WITH(OwnedFolder(folder.path("out")), Contains("another run is writing into this folder"));
    CHECK_NOTHROW(OwnedFolder(folder.path("other")));
  }
  CHECK_NOTHROW(OwnedFolder(folder.path("out")));
}

TEST_CASE("What the run before left goes, and what it did not write stays") {
  const Scratch folder;
  {
    const OwnedFolder own(folder.path("out"));
    write_file(folder.path("out/figure.svg"), "old");
    write_file(folder.path("out/inputs/press.csv"), "old");
    AtomicFileWriter(folder.path("out/signals.csv")).finish();
  }
  folder.file("out/notes.txt", "mine");
  folder.file("out/inputs/own.csv", "mine");
  {
    const OwnedFolder own(folder.path("out"));
    write_file(folder.path("out/run.json"), "new");
  }
  CHECK_FALSE(there(folder, "out/figure.svg"));
  CHECK_FALSE(there(folder, "out/signals.csv"));
  CHECK_FALSE(there(folder, "out/inputs/press.csv"));
  CHECK(there(folder, "out/notes.txt"));
  CHECK(there(folder, "out/inputs/own.csv"));
  CHECK(there(folder, "out/run.json"));
  const OwnedFolder again(folder.path("out"));
  CHECK_FALSE(there(folder, "out/run.json"));
}

TEST_CASE("What no run wrote is not written over, nor is a link followed") {
  const Scratch folder;
  for (const char* name : {"out", "elsewhere"}) std::filesystem::create_directory(folder.path(name));
  folder.file("out/signals.csv", "mine");
  folder.file("elsewhere/kept.csv", "mine");
  std::filesystem::create_symlink(folder.path("elsewhere/kept.csv"), folder.path("out/linked.csv"));
  std::filesystem::create_directory_symlink(folder.path("elsewhere"), folder.path("out/inputs"));
  const OwnedFolder own(folder.path("out"));
  for (const char* name : {"out/signals.csv", "out/linked.csv"}) {
    CHECK_THROWS_WITH(write_file(folder.path(name), "new"),
                      Contains("there is one already that no run wrote"));
    CHECK_THROWS_WITH(AtomicFileWriter(folder.path(name)),
                      Contains("there is one already that no run wrote"));
  }
  CHECK_THROWS_WITH(write_file(folder.path("out/inputs/kept.csv"), "new"),
                    Contains("a link leads out of the folder"));
  CHECK(read_file(folder.path("out/signals.csv")) == "mine");
  CHECK(read_file(folder.path("elsewhere/kept.csv")) == "mine");
  write_file(folder.path("out/own.csv"), "new");
  CHECK_NOTHROW(write_file(folder.path("out/own.csv"), "newer"));
}

TEST_CASE("Files that a run spares stay, and go with a later one that does not") {
  const Scratch folder;
  {
    const OwnedFolder own(folder.path("out"));
    write_file(folder.path("out/diagram.yaml"), "read");
  }
  {
    const OwnedFolder own(folder.path("out"),
                          [&] { return OwnedFolder::Files{folder.path("out/diagram.yaml")}; });
  }
  CHECK(there(folder, "out/diagram.yaml"));
  { const OwnedFolder own(folder.path("out")); }
  CHECK_FALSE(there(folder, "out/diagram.yaml"));
}

TEST_CASE("Pieces of files that were never finished go, other files of that ending stay") {
  const Scratch folder;
  std::filesystem::create_directory(folder.path("out"));
  folder.file("out/signals.csv.123-0.part", "half");
  folder.file("out/engine.part", "mine");
  const OwnedFolder own(folder.path("out"));
  CHECK_FALSE(there(folder, "out/signals.csv.123-0.part"));
  CHECK(there(folder, "out/engine.part"));
}

TEST_CASE("A list that names files outside of the folder removes none of them") {
  const Scratch folder;
  folder.file("beside.txt", "mine");
  std::filesystem::create_directory(folder.path("far"));
  std::filesystem::create_directory(folder.path("out"));
  folder.file("far/away.txt", "mine");
  folder.file("out/.stepwire",
              "../beside.txt\n" + folder.path("beside.txt") + "\nlink/away.txt\ninputs/../../beside.txt\n\n");
  std::filesystem::create_directory_symlink(folder.path("far"), folder.path("out/link"));
  const OwnedFolder own(folder.path("out"));
  CHECK(there(folder, "beside.txt"));
  CHECK(there(folder, "far/away.txt"));
}

TEST_CASE("A folder whose run writes nothing, or is refused, is left without a list") {
  const Scratch folder;
  std::filesystem::create_directory(folder.path("out"));
  folder.file("out/signals.mat", "mine");
  {
    OwnedFolder own(folder.path("out"));
    CHECK_THROWS_WITH(own.reserve({"signals.csv", "signals.mat"}),
                      Contains("signals.mat: there is one already"));
  }
  CHECK_FALSE(there(folder, "out/.stepwire"));
  folder.file("out/signals.csv", "mine, too");
  { const OwnedFolder own(folder.path("out")); }
  CHECK(there(folder, "out/signals.csv"));
}

}  // namespace stepwire::io
