#include "engine/base/text/base64.hpp"

#include <catch2/catch.hpp>

namespace stepwire::text {

TEST_CASE("base64 has the letters of the samples of RFC 4648, and any byte") {
  CHECK(base64("").empty());
  CHECK(base64("f") == "Zg==");
  CHECK(base64("fo") == "Zm8=");
  CHECK(base64("foo") == "Zm9v");
  CHECK(base64("foobar") == "Zm9vYmFy");
  CHECK(base64("\xff\xfe\xfd") == "//79");
}

}  // namespace stepwire::text
