#include "engine/base/unit/meaning.hpp"

#include <catch2/catch.hpp>

namespace stepwire::unit {

namespace {

Dimension of(const char* unit) {
  return parse_unit(unit)->dimension;
}

std::string other(const char* given, const char* wanted) {
  return other_meaning(of(given), of(wanted));
}

}  // namespace

TEST_CASE("a temperature and a difference of two have one scale and other zeros") {
  CHECK(parse_unit("degC")->to_si(20.0) == 293.15);
  CHECK(parse_unit("delta_degC")->to_si(1.0) == 1.0);
  CHECK(parse_unit("degF")->to_si(212.0) == Approx(373.15).epsilon(1e-15));
  CHECK(parse_unit("delta_degF")->to_si(9.0) == Approx(5.0).epsilon(1e-15));
  CHECK(parse_quantity("0.1 delta_degC")->value == 0.1);
}

TEST_CASE("a temperature is no difference of temperatures, and kelvin are either") {
  CHECK(other("degC", "delta_degC") == "is a temperature, but a difference of temperatures is meant");
  CHECK(other("delta_degF", "degC") == "is a difference of temperatures, but a temperature is meant");
  CHECK(other("degC", "degF").empty());
  CHECK(other("degC", "K").empty());
  CHECK(other("K", "delta_degC").empty());
  CHECK(other("degC", "m").empty());
  CHECK(other_meaning_of_number(of("degC"), of("delta_degC")) ==
        "is a temperature, but a difference of temperatures is meant; write it in K or delta_degC");
}

TEST_CASE("a temperature is at no fault beside half of one") {
  Dimension half = parse_unit("degC")->dimension;
  half.zeros = 0.5;
  CHECK(other_meaning(parse_unit("degC")->dimension, half).empty());
  CHECK(other_meaning(half, parse_unit("degC")->dimension) != "");
}

TEST_CASE("an angle per time is no frequency, and 1/s is either") {
  CHECK(parse_unit("rpm")->to_si(60.0) == Approx(6.283185307179586).epsilon(1e-15));
  for (const char* speed : {"rpm", "rad/s", "deg/s", "rev/min"}) {
    CHECK(other(speed, "Hz") == "is an angle per time, and a period has 2*pi rad");
    CHECK(other("kHz", speed) == "counts periods per time, of which each has 2*pi rad");
    CHECK(other(speed, "1/s").empty());
    CHECK(other("1/s", speed).empty());
  }
  CHECK(other("1/s", "Hz").empty());
  CHECK(other("Hz", "1/min").empty());
  CHECK(other("rpm", "rad/s").empty());
}

TEST_CASE("a frequency keeps its name") {
  CHECK(si_name(of("kHz")) == "Hz");
  CHECK(si_name(of("1/s")) == "1/s");
  CHECK(si_name(of("rpm")) == "rad/s");
  CHECK(si_name(of("m") * of("Hz")) == "m/s");
}

TEST_CASE("zeros of temperatures add and subtract") {
  CHECK(joined_zeros(1.0, 1.0, true) == 0.0);
  CHECK(joined_zeros(1.0, 1.0, false) == 2.0);
  CHECK(joined_zeros(1.0, {}, false) == 1.0);
  CHECK(joined_zeros({}, 1.0, true) == 0.0);
  CHECK(!joined_zeros(1.0, {}, true));
  CHECK(!joined_zeros({}, 0.0, false));
}

}  // namespace stepwire::unit
