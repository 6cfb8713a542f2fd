#include "engine/base/io/tree_hash.hpp"

#include <catch2/catch.hpp>
#include <filesystem>

#include "engine/base/io/environment_error.hpp"
#include "tests/engine/base/table/scratch.hpp"

using stepwire::io::tree_hash;

namespace fs = std::filesystem;

// python3 -c "import hashlib; h = lambda b: hashlib.sha256(b).hexdigest(); print(h(b''.join(
//   p + b'\0' + h(c).encode() + b'\n' for p, c in
//   [(b'B.txt', b''), (b'a.txt', b'one\n'), (b'a/b.txt', b'two\n'), (b'link', b'link:a/b.txt')])))"
TEST_CASE("the hash of a folder is that of a sorted list of paths and hashes") {
  const Scratch folder;
  fs::create_directories(folder.path("tree/empty"));
  fs::create_directory(folder.path("tree/a"));
  folder.file("tree/a/b.txt", "two\n");
  folder.file("tree/a.txt", "one\n");
  folder.file("tree/B.txt", "");
  fs::create_symlink("a/b.txt", folder.path("tree/link"));
  const auto hash = tree_hash(folder.path("tree"));
  CHECK(hash.files == 4);
  CHECK(hash.sha256 == "58e8caf1c379dca48c7e055ef36eb9ed79d3bf16e517d3e26be5885de25a94e0");
  folder.file("tree/a.txt", "One\n");
  CHECK(tree_hash(folder.path("tree")).sha256 != hash.sha256);
  CHECK_THROWS_AS(tree_hash(folder.path("nothing")), stepwire::io::EnvironmentError);
}

TEST_CASE("a known hash follows each change of content, also with the size and time of before") {
  using stepwire::io::known_tree_hash;
  const Scratch folder;
  fs::create_directory(folder.path("tree"));
  folder.file("tree/a.txt", "one\n");
  const std::string path = folder.path("tree"), file = folder.path("tree/a.txt");
  CHECK(known_tree_hash(path) == tree_hash(path).sha256);
  CHECK(known_tree_hash(path) == tree_hash(path).sha256);
  const auto time = fs::last_write_time(file);
  folder.file("tree/a.txt", "two\n");
  fs::last_write_time(file, time);
  CHECK(known_tree_hash(path) == tree_hash(path).sha256);
  fs::rename(file, folder.path("tree/b.txt"));
  CHECK(known_tree_hash(path) == tree_hash(path).sha256);
  CHECK_THROWS_AS(known_tree_hash(folder.path("nothing")), stepwire::io::EnvironmentError);
}
