#include "engine/base/io/cache.hpp"

#include <sys/stat.h>

#include <catch2/catch.hpp>

#include "engine/base/io/file.hpp"
#include "tests/engine/base/table/scratch.hpp"

namespace stepwire::io {
using Catch::Contains;

namespace {

const std::string name = "0123456789abcdef0123456789abcdef.so";

unsigned mode_of(const std::string& path) {
  struct stat status {};
  REQUIRE(::stat(path.c_str(), &status) == 0);
  return status.st_mode & 0777u;
}

}  // namespace

TEST_CASE("What is kept is found again, by its name alone, and belongs to the caller alone") {
  const Scratch folder;
  const Cache cache(folder.path("new/cache"));
  CHECK_FALSE(cache.find(name));
  const std::string content("\0binary\n\xff", 9);
  cache.keep(name, content);
  CHECK(cache.find(name) == content);
  cache.keep(name, "");
  CHECK(cache.find(name) == "");
  CHECK(mode_of(folder.path("new/cache")) == 0700);
  CHECK(mode_of(folder.path("new/cache/" + name)) == 0600);
}

TEST_CASE("An entry that is damaged in any byte, cut off, or another's is not found") {
  const Scratch folder;
  const Cache cache(folder.path("cache"));
  const std::string path = folder.path("cache/" + name);
  cache.keep(name, "the content of an entry");
  const std::string whole = read_file(path);
  const auto found_with = [&](const std::string& bytes) {
    std::ofstream(path, std::ios::binary | std::ios::trunc) << bytes;
    return cache.find(name).has_value();
  };
  CHECK(found_with(whole));
  for (std::size_t i = 0; i < whole.size(); ++i) {
    std::string other = whole;
    other[i] = static_cast<char>(other[i] ^ 4);
    CHECK_FALSE(found_with(other));
    CHECK_FALSE(found_with(whole.substr(0, i)));
  }
  CHECK_FALSE(found_with(whole + "more"));
  const std::string beside = "ffffffffffffffffffffffffffffffff.so";
  cache.keep(beside, "other");
  CHECK_FALSE(found_with(read_file(folder.path("cache/" + beside))));
}

TEST_CASE("A folder or an entry that is open to others is refused") {
  const Scratch folder;
  const Cache cache(folder.path("cache"));
  const std::string path = folder.path("cache/" + name);
  cache.keep(name, "content");
  for (const unsigned mode : {0644u, 0620u, 0602u}) {
    ::chmod(path.c_str(), mode);
    CHECK_FALSE(cache.find(name));
  }
  cache.keep(name, "content");
  CHECK(cache.find(name));
  for (const unsigned mode : {0755u, 0770u, 0701u}) {
    ::chmod(folder.path("cache").c_str(), mode);
    CHECK_FALSE(cache.find(name));
    cache.keep("00000000000000000000000000000000.so", "content");
  }
  ::chmod(folder.path("cache").c_str(), 0700);
  CHECK_FALSE(cache.find("00000000000000000000000000000000.so"));
}

TEST_CASE("Links and pipes in the place of an entry are not followed and not waited for") {
  const Scratch folder;
  const Cache cache(folder.path("cache"));
  cache.keep(name, "content");
  std::filesystem::rename(folder.path("cache/" + name), folder.path("away"));
  std::filesystem::create_symlink(folder.path("away"), folder.path("cache/" + name));
  CHECK_FALSE(cache.find(name));
  std::filesystem::remove(folder.path("cache/" + name));
  REQUIRE(::mkfifo(folder.path("cache/" + name).c_str(), 0600) == 0);
  CHECK_FALSE(cache.find(name));
}

TEST_CASE("The least recently used entries go when there are too many, and nothing else does") {
  const Scratch folder;
  const Cache cache(folder.path("cache"), 3000);
  cache.keep(name, "first");
  std::ofstream(folder.path("cache/notes.txt")) << std::string(5000, 'x');
  const auto entry = [](int i) { return std::string(31, 'a') + static_cast<char>('0' + i) + ".so"; };
  const auto now = std::filesystem::file_time_type::clock::now();
  for (int i = 0; i < 4; ++i) {
    cache.keep(entry(i), std::string(1000, 'x'));
    std::filesystem::last_write_time(folder.path("cache/" + entry(i)), now - std::chrono::minutes(60 - i));
  }
  cache.keep(entry(4), "small");
  CHECK_FALSE(cache.find(entry(0)));
  CHECK(cache.find(entry(3)));
  CHECK(cache.find(entry(4)));
  CHECK(std::filesystem::exists(folder.path("cache/notes.txt")));
}

TEST_CASE("Where nothing can be kept nothing is found, and there is a reason") {
  const Scratch folder;
  folder.file("taken", "a file");
  const Cache cache(folder.path("taken/below"));
  cache.keep(name, "content");
  CHECK_FALSE(cache.find(name));
}

}  // namespace stepwire::io
