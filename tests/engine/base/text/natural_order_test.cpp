#include "engine/base/text/natural_order.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <string>
#include <vector>

namespace stepwire::text {

TEST_CASE("names are in the order of their numbers") {
  std::vector<std::string> names{"100-c.yaml", "11-b.yaml", "a10",        "9-a.yaml",
                                 "a9b",        "a9",        "011-b.yaml", "part"};
  std::ranges::sort(names, naturally_less);
  CHECK(names == std::vector<std::string>{"9-a.yaml", "011-b.yaml", "11-b.yaml", "100-c.yaml", "a9", "a9b",
                                          "a10", "part"});
}

TEST_CASE("no name comes before itself, and numbers of any length are compared") {
  CHECK_FALSE(naturally_less("9", "9"));
  CHECK_FALSE(naturally_less("", ""));
  CHECK(naturally_less("", "a"));
  CHECK(naturally_less("99999999999999999999998", "99999999999999999999999"));
  CHECK(naturally_less("2", "10000000000000000000000"));
}

}  // namespace stepwire::text
