#include <catch2/catch.hpp>
#include <string>

#include "engine/base/unit/unit.hpp"

namespace stepwire::unit {

namespace {

double si(const std::string& text) {
  INFO(text);
  const auto quantity = parse_quantity(text);
  REQUIRE(quantity);
  return quantity->value;
}

}  // namespace

TEST_CASE("a number with a unit is its decimal SI value to the last bit") {
  CHECK(si("5 mm") == 0.005);
  CHECK(si("5mm") == 0.005);
  CHECK(si("2kg") == 2.0);
  CHECK(si("0.1 ms") == 1e-4);
  CHECK(si("-0.35 A") == -0.35);
  CHECK(si("+0.07 A/mm") == 70.0);
  CHECK(si("1 kHz") == 1000.0);
  CHECK(si("5 1/s") == 5.0);
  CHECK(si("1 1/s") == 1.0);
  CHECK(si("  3 mm/s ") == 0.003);
  CHECK(si("0.2 lbf.in") == 0.02259696580552334);
  CHECK(si("20 degC") == 293.15);
  CHECK(si("50%") == 0.5);
  CHECK(si("1e3 mm") == 1.0);
  CHECK(si("0.3 mm") == 0.0003);
  CHECK(si("0.7 us") == 7e-7);
}

TEST_CASE("a bare number is exactly as written and has no dimension") {
  CHECK(si("2e-3") == 2e-3);
  CHECK(si(".5") == 0.5);
  CHECK(si("5.") == 5.0);
  CHECK(si("010") == 10.0);
  CHECK(si("1.7976931348623157e308") == 1.7976931348623157e308);
  CHECK_FALSE(parse_quantity("3")->dimension);
  CHECK(parse_quantity("3 %")->dimension == Dimension{});
  CHECK(parse_quantity("3 mm/s")->dimension == Dimension{{1, 0, -1}});
}

TEST_CASE("what is no quantity is refused") {
  for (const char* text :
       {"",       " ",          "nan",      "inf",   "-inf",  "infinity", "1e999",  "-1e999",
        "0x10",   "0x1p3",      "1e308 km", "mm",    "5 taw", "2 e-3",    "5 e",    "1/s",
        "5/s",    "51/s",       "5 1",      "- 5",   "+-5",   "--5",      "1_000",  "1,5",
        "5 mm 3", "1 h 30 min", "5 5 m",    "1.2.3", "2*3",   "nan mm",   "1e-400", "1e-320 um"}) {
    INFO(text);
    CHECK_FALSE(parse_quantity(text));
  }
}

}  // namespace stepwire::unit
