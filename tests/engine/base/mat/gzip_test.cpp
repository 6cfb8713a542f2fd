#include <zlib.h>

#include <catch2/catch.hpp>

#include "engine/base/mat/deflate.hpp"

namespace stepwire::mat {
namespace {

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
