#include <sys/stat.h>

#include <catch2/catch.hpp>
#include <thread>
#include <vector>

#include "engine/base/io/file.hpp"
#include "tests/engine/base/io/small_disk.hpp"
#include "tests/engine/base/table/scratch.hpp"

namespace stepwire::table {

TEST_CASE("a file is written whole, its folders are made, and nothing else is left") {
  const Scratch scratch;
  const std::string content = std::string("a\0b\r\n", 5) + std::string(100'000, 'x');
  io::write_file(scratch.path("deep/er/a.txt"), content);
  CHECK(io::read_file(scratch.path("deep/er/a.txt")) == content);
  io::write_file(scratch.path("a.txt"), "first");
  io::write_file(scratch.path("a.txt"), "");
  CHECK(io::read_file(scratch.path("a.txt")).empty());
  CHECK(scratch.files() == 2);
}

TEST_CASE("a file that cannot be replaced keeps its content and says why") {
  const Scratch scratch;
  std::filesystem::create_directories(scratch.path("folder"));
  CHECK_THROWS_WITH(io::write_file(scratch.path("folder"), "x"), Catch::Contains("folder: Is a directory"));
  scratch.file("a.txt", "old");
  CHECK_THROWS_WITH(io::write_file(scratch.path("a.txt/b.txt"), "x"),
                    Catch::Contains("a.txt: Not a directory"));
  CHECK_THROWS_AS(io::write_file(scratch.path("a.txt/b.txt"), "x"), io::EnvironmentError);
  CHECK(io::read_file(scratch.path("a.txt")) == "old");
  CHECK(scratch.files() == 2);
}

TEST_CASE("a write that ends half way leaves the old file and no other") {
  const Scratch scratch;
  const std::string path = scratch.file("a.txt", "old");
  std::string message;
  try {
    const SmallDisk small(10'000);
    io::write_file(path, std::string(1'000'000, 'x'));
  } catch (const io::EnvironmentError& error) {
    message = error.what();
  }
  CHECK(message == path + ": File too large");
  CHECK(io::read_file(path) == "old");
  CHECK(scratch.files() == 1);
}

TEST_CASE("a full device is noticed even where only the last flush fails, and stays a device") {
  if (!std::filesystem::is_character_file("/dev/full")) {
    WARN("no /dev/full here");
    return;
  }
  const Scratch scratch;
  std::filesystem::create_symlink("/dev/full", scratch.path("full.csv"));
  CHECK_THROWS_WITH(io::write_file(scratch.path("full.csv"), "x"),
                    Catch::Contains("full.csv: No space left on device"));
  CHECK(std::filesystem::is_character_file("/dev/full"));
  CHECK(scratch.files() == 1);
}

TEST_CASE("a link stays a link and what it points to is replaced") {
  const Scratch scratch;
  const std::string target = scratch.file("target.txt", "old");
  std::filesystem::create_symlink(target, scratch.path("link.txt"));
  io::write_file(scratch.path("link.txt"), "new");
  CHECK(std::filesystem::is_symlink(scratch.path("link.txt")));
  CHECK(io::read_file(target) == "new");
}

TEST_CASE("threads that write one file leave one whole version of it") {
  const Scratch scratch;
  const std::string path = scratch.path("a.txt");
  std::vector<std::thread> threads;
  for (const char c : {'a', 'b', 'c', 'd'}) {
    threads.emplace_back([&path, c] {
      for (int i = 0; i < 20; ++i) io::write_file(path, std::string(100'000, c));
    });
  }
  for (std::thread& thread : threads) thread.join();
  const std::string content = io::read_file(path);
  CHECK(content == std::string(100'000, content.at(0)));
  CHECK(scratch.files() == 1);
}

}  // namespace stepwire::table
