// A small file may unpack to gigabytes.
#include <zlib.h>

#include <catch2/catch.hpp>

#include "engine/base/mat/mat_file.hpp"
#include "engine/base/table/table_file.hpp"
#include "tests/engine/base/table/scratch.hpp"

namespace stepwire::mat {

namespace {

std::string words(const std::vector<std::uint32_t>& numbers) {
  return {reinterpret_cast<const char*>(numbers.data()), numbers.size() * sizeof(std::uint32_t)};
}

/// Returns a file of level 5 with a compressed column x of `count` zeros.
std::string packed_zeros(std::uint32_t count) {
  const std::string head =
      words({14, 48 + 8 * count, 6, 8, 6, 0, 5, 8, count, 1, 0x0001'0001, 'x', 9, 8 * count});
  z_stream stream{};
  REQUIRE(deflateInit(&stream, Z_BEST_COMPRESSION) == Z_OK);
  std::string packed(deflateBound(&stream, head.size() + std::size_t{8} * count) / 200 + 1000, '\0');
  stream.next_out = reinterpret_cast<Bytef*>(packed.data());
  stream.avail_out = static_cast<uInt>(packed.size());
  const auto feed = [&](const std::string& part, int flush) {
    stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(part.data()));
    stream.avail_in = static_cast<uInt>(part.size());
    return deflate(&stream, flush);
  };
  feed(head, Z_NO_FLUSH);
  const std::string zeros(8 * (count % 1024), '\0'), many(8 * 1024, '\0');
  feed(zeros, Z_NO_FLUSH);
  for (std::uint32_t i = 0; i < count / 1024; ++i) feed(many, Z_NO_FLUSH);
  REQUIRE(feed("", Z_FINISH) == Z_STREAM_END);
  packed.resize(packed.size() - stream.avail_out);
  deflateEnd(&stream);
  const std::uint16_t mark[] = {0x0100, 0x4D49};
  return std::string(124, ' ') + std::string(reinterpret_cast<const char*>(mark), 4) +
         words({15, static_cast<std::uint32_t>(packed.size())}) + packed;
}

}  // namespace

TEST_CASE("what unpacks to much more than its file holds is refused before it is unpacked") {
  const Scratch scratch;
  const std::string many = scratch.file("many.mat", packed_zeros(20'000'000));
  CHECK_THROWS_WITH(read_mat(many), Catch::Contains("'x' unpacks to 152 MB, and what lies before it to 0 MB; "
                                                    "a file of this size may unpack to"));
}

TEST_CASE("a column of zeros that packs well is read all the same") {
  const Scratch scratch;
  const table::Table table = read_mat(scratch.file("few.mat", packed_zeros(1'000'000)));
  REQUIRE(table.columns.size() == 1);
  CHECK(table.columns[0].values == std::vector<double>(1'000'000, 0.0));
}

}  // namespace stepwire::mat
