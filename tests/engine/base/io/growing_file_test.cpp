#include "engine/base/io/atomic_file_writer.hpp"

#include <catch2/catch.hpp>

#include "engine/base/io/environment_error.hpp"
#include "engine/base/io/file.hpp"
#include "tests/engine/base/io/small_disk.hpp"
#include "tests/engine/base/table/scratch.hpp"

namespace stepwire::io {

TEST_CASE("a growing file has its name when it is whole, and replaces the one before") {
  const Scratch scratch;
  const std::string path = scratch.file("a.csv", "old");
  AtomicFileWriter file(path);
  file.append("one\n");
  file.append("two\n");
  CHECK(read_file(path) == "old");
  file.finish();
  CHECK(read_file(path) == "one\ntwo\n");
  CHECK(file.trouble().empty());
  CHECK(scratch.files() == 1);
}

TEST_CASE("a growing file that is not finished leaves nothing") {
  const Scratch scratch;
  { AtomicFileWriter(scratch.path("a.csv")).append("one\n"); }
  CHECK(scratch.files() == 0);
}

TEST_CASE(
    "a piece that the disk does not take is an error, there and at the end, and the file before stays") {
  const Scratch scratch;
  const std::string path = scratch.file("a.csv", "old"), why = path + ": File too large";
  {
    AtomicFileWriter file(path);
    file.append("first\n");
    {
      const SmallDisk small(20);
      CHECK_THROWS_WITH(file.append("a piece that does not fit\n"), why);
    }
    file.append("a piece that fits again\n");
    CHECK_THROWS_WITH(file.finish(), why);
    CHECK_THROWS_AS(file.finish(), EnvironmentError);
  }
  CHECK(read_file(path) == "old");
  CHECK(scratch.files() == 1);
}

TEST_CASE("pieces that may be lost are lost whole, and those that fit later are written") {
  const Scratch scratch;
  AtomicFileWriter file(scratch.path("a.csv"));
  CHECK(file.try_append("first\n"));
  {
    const SmallDisk small(20);
    CHECK_FALSE(file.try_append("a piece that does not fit\n"));
  }
  CHECK(file.try_append("last\n"));
  CHECK(file.trouble() == scratch.path("a.csv") + ": File too large");
  file.finish();
  CHECK(read_file(scratch.path("a.csv")) == "first\nlast\n");
}

TEST_CASE("a growing file that cannot be says why") {
  const Scratch scratch;
  scratch.file("a", "a file");
  CHECK_THROWS_WITH(AtomicFileWriter(scratch.path("a/b.csv")),
                    Catch::Contains("a: Not a directory") || Catch::Contains("a: File exists"));
}

}  // namespace stepwire::io
