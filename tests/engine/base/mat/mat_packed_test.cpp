#include <zlib.h>

#include <catch2/catch.hpp>

#include "engine/base/io/file.hpp"
#include "engine/base/mat/deflate.hpp"
#include "engine/base/mat/mat_file.hpp"
#include "tests/engine/base/table/scratch.hpp"

namespace stepwire::mat {
namespace {

TEST_CASE("a MAT file with packed variables has the same numbers and is smaller") {
  const Scratch folder;
  table::Table table;
  table.columns = {{"time", "s", {}}, {"rig.at.1", "m", {}}};
  for (int i = 0; i < 5000; ++i) {
    table.columns[0].values.push_back(i * 0.001);
    table.columns[1].values.push_back(i % 7 / 3.0);
  }
  write_mat(folder.path("plain.mat"), table);
  const std::string plain = io::read_file(folder.path("plain.mat")), packed = packed_mat(plain);
  io::write_file(folder.path("packed.mat"), packed);
  CHECK(packed.size() < plain.size() / 2);
  const table::Table a = read_mat(folder.path("plain.mat")), b = read_mat(folder.path("packed.mat"));
  REQUIRE(a.columns.size() == b.columns.size());
  for (std::size_t i = 0; i < a.columns.size(); ++i) {
    CHECK(a.columns[i].name == b.columns[i].name);
    CHECK(a.columns[i].unit == b.columns[i].unit);
    CHECK(a.columns[i].values == b.columns[i].values);
  }
  CHECK(packed_mat("no MAT file") == "no MAT file");
}

TEST_CASE("gzip gives back every byte, also of an empty file, and names no time") {
  for (const std::string& text : {std::string(), std::string(300'000, 'a') + "end"}) {
    const std::string packed = gzip_packed(text);
    REQUIRE(packed.size() > 10);
    CHECK(packed.substr(0, 3) == "\x1f\x8b\x08");
    CHECK(packed.substr(4, 4) == std::string(4, '\0'));
    z_stream stream{};
    REQUIRE(inflateInit2(&stream, 15 + 16) == Z_OK);
    std::string back(text.size() + 1, '\0');
    stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(packed.data()));
    stream.avail_in = static_cast<uInt>(packed.size());
    stream.next_out = reinterpret_cast<Bytef*>(back.data());
    stream.avail_out = static_cast<uInt>(back.size());
    CHECK(inflate(&stream, Z_FINISH) == Z_STREAM_END);
    back.resize(back.size() - stream.avail_out);
    inflateEnd(&stream);
    CHECK(back == text);
  }
}

}  // namespace
}  // namespace stepwire::mat
