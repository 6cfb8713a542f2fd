#include "engine/base/data_file/table_cache.hpp"

#include <atomic>
#include <catch2/catch.hpp>
#include <chrono>
#include <thread>

#include "engine/base/table/table_file.hpp"
#include "tests/engine/base/table/scratch.hpp"

namespace stepwire::data_file {

namespace {

namespace fs = std::filesystem;

/// A file that has not changed for an hour, or `minutes` less.
std::string old_file(const Scratch& scratch, const std::string& name, const std::string& text,
                     int minutes = 0) {
  const std::string path = scratch.file(name, text);
  fs::last_write_time(path, fs::file_time_type::clock::now() - std::chrono::minutes(60 - minutes));
  return path;
}

double first_number(TableCache& cache, const std::string& path) {
  return cache.read(path)->columns.at(0).values.at(0);
}

}  // namespace

TEST_CASE("a table is read once as long as its file has not changed") {
  const Scratch scratch;
  TableCache cache(100);
  const std::string path = old_file(scratch, "a.csv", "x\n1\n");
  const auto time = fs::last_write_time(path);
  CHECK(first_number(cache, path) == 1.0);
  scratch.file("a.csv", "x\n2\n");
  fs::last_write_time(path, time);  // time and size are the same, so the value shows that the cache answered
  CHECK(first_number(cache, path) == 1.0);
}

TEST_CASE("a file with another time or size is read again") {
  const Scratch scratch;
  TableCache cache(100);
  const std::string path = old_file(scratch, "a.csv", "x\n1\n");
  CHECK(first_number(cache, path) == 1.0);
  old_file(scratch, "a.csv", "x\n2\n", 1);
  CHECK(first_number(cache, path) == 2.0);
  const auto time = fs::last_write_time(path);
  scratch.file("a.csv", "x\n3\n4\n");
  fs::last_write_time(path, time);
  CHECK(first_number(cache, path) == 3.0);
  CHECK(cache.numbers() == 2);
}

TEST_CASE("a file that changes faster than clocks can tell is read every time") {
  const Scratch scratch;
  TableCache cache(100);
  const std::string path = scratch.file("a.csv", "x\n1\n");
  CHECK(first_number(cache, path) == 1.0);
  scratch.file("a.csv", "x\n2\n");
  CHECK(first_number(cache, path) == 2.0);
  CHECK(cache.numbers() == 0);
}

TEST_CASE("of too many tables those asked for longest ago are dropped") {
  const Scratch scratch;
  TableCache cache(5);
  const std::string a = old_file(scratch, "a.csv", "x\n1\n2\n"), b = old_file(scratch, "b.csv", "x\n3\n4\n"),
                    c = old_file(scratch, "c.csv", "x\n5\n6\n"),
                    large = old_file(scratch, "large.csv", "x\n1\n2\n3\n4\n5\n6\n");
  for (const auto& path : {a, b, a, c}) cache.read(path);
  CHECK(cache.numbers() == 4);
  const auto time = fs::last_write_time(a);
  for (const std::string name : {"a.csv", "b.csv"}) scratch.file(name, "x\n8\n9\n");
  for (const auto& path : {a, b}) fs::last_write_time(path, time);
  CHECK(first_number(cache, a) == 1.0);   // kept
  CHECK(cache.read(large)->rows() == 6);  // more than all that may be kept
  CHECK(cache.numbers() == 4);
}

TEST_CASE("files that are not there or are no tables are told as ever, and not kept") {
  const Scratch scratch;
  TableCache cache(100);
  CHECK_THROWS_AS(cache.read(scratch.path("none.csv")), io::EnvironmentError);
  CHECK_THROWS_AS(cache.read(old_file(scratch, "bad.csv", "x,y\n1,2,3\n")), table::TableError);
  CHECK(cache.numbers() == 0);
}

TEST_CASE("several threads may read the same tables") {
  const Scratch scratch;
  TableCache cache(3);
  const std::string a = old_file(scratch, "a.csv", "x\n1\n2\n"), b = old_file(scratch, "b.csv", "x\n3\n4\n");
  std::atomic<int> wrong = 0;
  {
    std::vector<std::jthread> threads;
    for (int thread = 0; thread < 4; ++thread)
      threads.emplace_back([&, thread] {
        for (int i = 0; i < 50; ++i) {
          const bool first = (i + thread) % 2 == 0;
          if (first_number(cache, first ? a : b) != (first ? 1.0 : 3.0)) ++wrong;
        }
      });
  }
  CHECK(wrong == 0);
  CHECK(cache.numbers() == 2);
}

}  // namespace stepwire::data_file
