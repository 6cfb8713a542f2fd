#include "engine/base/io/atomic_file_writer.hpp"

#include <sys/resource.h>

#include <catch2/catch.hpp>
#include <csignal>

#include "engine/base/io/file.hpp"
#include "tests/engine/base/table/scratch.hpp"

namespace stepwire::io {

namespace {

/// While it lives a file may have so many bytes, which fails writes as a full disk does.
class SmallDisk {
 public:
  explicit SmallDisk(rlim_t bytes) : handler_(std::signal(SIGXFSZ, SIG_IGN)) {
    getrlimit(RLIMIT_FSIZE, &before_);
    rlimit small = before_;
    small.rlim_cur = bytes;
    setrlimit(RLIMIT_FSIZE, &small);
  }
  ~SmallDisk() {
    setrlimit(RLIMIT_FSIZE, &before_);
    std::signal(SIGXFSZ, handler_);
  }

 private:
  rlimit before_{};
  void (*handler_)(int);
};

}  // namespace

TEST_CASE("a growing file has its name when it is whole, and replaces the one before") {
  const Scratch scratch;
  const std::string path = scratch.file("a.csv", "old");
  AtomicFileWriter file(path);
  CHECK(file.append("one\n"));
  CHECK(file.append("two\n"));
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

TEST_CASE("a full disk loses whole pieces, and what fits later is written") {
  const Scratch scratch;
  AtomicFileWriter file(scratch.path("a.csv"));
  CHECK(file.append("first\n"));
  {
    const SmallDisk small(20);
    CHECK_FALSE(file.append("a piece that does not fit\n"));
  }
  CHECK(file.append("last\n"));
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
