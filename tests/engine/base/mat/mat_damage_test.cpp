// Damaged files are refused or give the same numbers, whatever uninitialised memory contains.
#include <malloc.h>

#include <catch2/catch.hpp>
#include <cstring>

#include "engine/base/mat/mat_file.hpp"
#include "engine/base/table/table_file.hpp"
#include "tests/engine/base/mat/mat_samples.hpp"
#include "tests/engine/base/table/scratch.hpp"

namespace stepwire::mat {
using testing::write_by_library;

namespace {

/// Returns the result of reading as a text: the columns with their bits, or the refusal.
std::string outcome(const std::string& path) {
  try {
    std::string text;
    for (const table::Column& column : read_mat(path).columns) {
      text += column.name + ":";
      text.append(reinterpret_cast<const char*>(column.values.data()), column.values.size() * sizeof(double));
    }
    return text;
  } catch (const table::TableError& error) {
    return error.what();
  }
}

/// True if reading gives the same result with two different patterns in fresh memory.
bool reads_alike(const std::string& path) {
  ::mallopt(M_PERTURB, 0x5A);
  const std::string first = outcome(path);
  ::mallopt(M_PERTURB, 0xC3);
  const std::string second = outcome(path);
  ::mallopt(M_PERTURB, 0);
  return first == second;
}

template <class Number>
std::string bytes_of(const std::vector<Number>& numbers) {
  return {reinterpret_cast<const char*>(numbers.data()), numbers.size() * sizeof(Number)};
}

using Words = std::vector<std::uint32_t>;

/// A file of level 5 with one variable x, whose parts are given: its dimensions, and type and bytes of its
/// numbers.
std::string level_5(const Words& size, std::uint32_t type, std::string numbers,
                    std::uint32_t array_class = 6) {
  std::string body = bytes_of(Words{6, 8, array_class, 0}) +
                     bytes_of(Words{5, static_cast<std::uint32_t>(4 * size.size())}) + bytes_of(size);
  if (size.size() % 2 == 1) body += std::string(4, '\0');
  body += bytes_of(Words{0x0001'0001, 'x'});
  const auto length = static_cast<std::uint32_t>(numbers.size());
  numbers.resize((numbers.size() + 7) / 8 * 8);
  body += bytes_of(Words{type, length}) + numbers;
  std::string head(124, ' ');
  return head + bytes_of(std::vector<std::uint16_t>{0x0100, 0x4D49}) +
         bytes_of(Words{14, static_cast<std::uint32_t>(body.size())}) + body;
}

std::string read_of(const std::string& content) {
  const Scratch scratch;
  const std::string folder = scratch.path(""), text = outcome(scratch.file("x.mat", content));
  return text.starts_with(folder) ? text.substr(folder.size()) : text;
}

void check_all_changes(mat_ft version, std::size_t stride) {
  const Scratch scratch;
  const std::string path = scratch.path("a.mat");
  write_by_library(path, version);
  const std::string whole = io::read_file(path);
  for (std::size_t at = 0; at < whole.size(); at += stride) {
    for (const int change : {0x01, 0x80, 0xFF}) {
      std::string damaged = whole;
      damaged[at] = static_cast<char>(damaged[at] ^ change);
      scratch.file("a.mat", damaged);
      INFO("level " << version << ", byte " << at << " changed by " << change);
      CHECK(reads_alike(path));
    }
    scratch.file("a.mat", whole.substr(0, at));
    INFO("level " << version << ", cut at " << at);
    CHECK(reads_alike(path));
  }
}

}  // namespace

TEST_CASE("a file that is changed at any byte, or cut there, is refused or reads alike twice", "[full]") {
  check_all_changes(MAT_FT_MAT4, 1);
  check_all_changes(MAT_FT_MAT5, 1);
  check_all_changes(MAT_FT_MAT73, 997);  // which other libraries read, slowly
}

TEST_CASE("an element that does not fit its dimensions is refused with its variable") {
  const std::string three = bytes_of(std::vector<double>{1.0, 2.0, 3.0});
  CHECK(read_of(level_5({3, 1}, 9, three)) == "x:" + three);
  CHECK(read_of(level_5({4, 1}, 9, three)) ==
        "x.mat: 'x' is damaged: it is 4 x 1 and has 24 bytes of numbers, not 32");
  CHECK(read_of(level_5({2, 1}, 9, three)) ==
        "x.mat: 'x' is damaged: it is 2 x 1 and has 24 bytes of numbers, not 16");
  CHECK(read_of(level_5({3, 1}, 9, "")) ==
        "x.mat: 'x' is damaged: it is 3 x 1 and has 0 bytes of numbers, not 24");
}

TEST_CASE("numbers of a type that is none, or that the variable cannot have, are refused with it") {
  const std::string three = bytes_of(std::vector<double>{1.0, 2.0, 3.0});
  for (const std::uint32_t type : {0u, 8u, 10u, 11u, 14u, 15u, 17u, 99u})
    CHECK(read_of(level_5({3, 1}, type, three)) == "x.mat: 'x' is damaged: its numbers are of type " +
                                                       std::to_string(type) + ", which they cannot be");
  CHECK_THAT(read_of(level_5({3, 1}, 9, three, 10)), Catch::Contains("'x' is damaged"));  // int16 of doubles
}

TEST_CASE("numbers that are stored in a smaller type than their variable has are those numbers") {
  const std::string wanted = "x:" + bytes_of(std::vector<double>{1.0, 200.0, 3.0});
  CHECK(read_of(level_5({3, 1}, 2, bytes_of(std::vector<std::uint8_t>{1, 200, 3}))) == wanted);
  CHECK(read_of(level_5({3, 1}, 3, bytes_of(std::vector<std::int16_t>{1, 200, 3}))) == wanted);
  CHECK(read_of(level_5({3, 1}, 12, bytes_of(std::vector<std::int64_t>{1, 200, 3}))) == wanted);
}

TEST_CASE("dimensions beyond any memory are refused") {
  CHECK_THAT(read_of(level_5({0x7FFF'FFFF, 0x7FFF'FFFF, 0x7FFF'FFFF}, 9, "")),
             Catch::Contains("beyond any memory"));
  CHECK_THAT(read_of(level_5({0xFFFF'FFFF, 1}, 9, "")), Catch::Contains("below 0"));
}

}  // namespace stepwire::mat
