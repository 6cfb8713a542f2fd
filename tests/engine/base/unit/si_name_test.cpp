#include <catch2/catch.hpp>
#include <string>

#include "engine/base/unit/unit.hpp"

namespace stepwire::unit {

TEST_CASE("a dimension is named as an engineer writes it") {
  for (const char* text : {"N",
                           "N m",
                           "N/m",
                           "N s/m",
                           "m/s",
                           "m/s^2",
                           "A/m",
                           "V",
                           "W",
                           "Pa",
                           "kg",
                           "kg m^2",
                           "m",
                           "s",
                           "A",
                           "1/s",
                           "1/s^2",
                           "1",
                           "ohm",
                           "N m/A",
                           "K",
                           "m^0.5",
                           "kg m^2/(s^3 K^2)",
                           "1/(m K)"}) {
    CHECK(si_name(parse_unit(text)->dimension) == text);
  }
}

TEST_CASE("an energy is written as a torque and a frequency in hertz") {
  CHECK(si_name(parse_unit("J")->dimension) == "N m");
  CHECK(si_name(parse_unit("Hz")->dimension) == "Hz");
  CHECK(si_name(parse_unit("deg")->dimension) == "rad");
}

TEST_CASE("every name reads back to the dimension that it was given for") {
  for (int code = 0; code < 4 * 5 * 7 * 5 * 3; ++code) {
    Dimension dimension;
    dimension.exponents = {double(code % 4 - 2), double(code / 4 % 5 - 2), double(code / 20 % 7 - 4),
                           double(code / 140 % 5 - 2), double(code / 700 - 1)};
    const std::string name = si_name(dimension);
    INFO(name);
    const auto unit = parse_unit(name);
    REQUIRE(unit);
    REQUIRE(unit->dimension == dimension);
    REQUIRE(unit->scale == 1.0L);
  }
}

TEST_CASE("dimensions multiply, divide and have powers") {
  const Dimension force = parse_unit("N")->dimension;
  const Dimension length = parse_unit("m")->dimension;
  CHECK(si_name(force * length) == "N m");
  CHECK(si_name(force / length) == "N/m");
  CHECK(power(length * length, 0.5) == length);
}

}  // namespace stepwire::unit
