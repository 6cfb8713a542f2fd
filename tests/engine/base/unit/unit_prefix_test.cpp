#include <catch2/catch.hpp>
#include <string>
#include <string_view>

#include "engine/base/unit/unit.hpp"

namespace stepwire::unit {

namespace {

std::string prefix(std::string_view text) {
  return std::string(text.substr(0, unit_prefix(text)));
}

}  // namespace

TEST_CASE("the longest start that is a unit is found") {
  CHECK(prefix("mm/s + x") == "mm/s");
  CHECK(prefix("mm + x") == "mm");
  CHECK(prefix("A/x") == "A");
  CHECK(prefix("mm && y") == "mm");
  CHECK(prefix("N.m)") == "N.m");
  CHECK(prefix("N m") == "N");
  CHECK(prefix("m^2*x") == "m^2");
  CHECK(prefix("m^x") == "m");
  CHECK(prefix("m-1") == "m");
  CHECK(prefix("mm*2") == "mm");
  CHECK(prefix("mm/2") == "mm");
  CHECK(prefix("1/s") == "1/s");
  CHECK(prefix("%") == "%");
  CHECK(prefix("J/(kg.K)+1") == "J/(kg.K)");
  CHECK(prefix("N/(x)") == "N");
}

TEST_CASE("a name is never cut in two") {
  CHECK(prefix("sin(x)").empty());
  CHECK(prefix("min(x, y)").empty());
  CHECK(prefix("s.x").empty());
  CHECK(prefix("mx").empty());
  CHECK(prefix("e").empty());
  CHECK(prefix("pi").empty());
  CHECK(prefix("1").empty());
  CHECK(prefix("mm/s.x") == "mm");
  CHECK(prefix("mm*min(x, y)") == "mm");
  CHECK(prefix("").empty());
}

TEST_CASE("after a sign a taken name is no unit") {
  const auto taken = [](std::string_view name) { return name == "m" || name == "s.x" || name == "g.s"; };
  CHECK(unit_prefix("A/m", taken) == 1);
  CHECK(unit_prefix("A/mm", taken) == 4);
  CHECK(unit_prefix("m/s", taken) == 3);
  CHECK(unit_prefix("N*g.s", taken) == 1);
}

}  // namespace stepwire::unit
