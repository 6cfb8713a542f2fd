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

TEST_CASE("a unit with degC among its factors is one of differences, until the temperature cancels") {
  for (const char* unit :
       {"W/degC", "J/kg/degF", "degC.m", "degC2", "degC^0.5", "1/(m degC)", "V/delta_degC"})
    CHECK(of(unit).per_difference);
  for (const char* unit : {"degC", "degC^1", "W/K", "degC/degC", "delta_degC", "m"})
    CHECK_FALSE(of(unit).per_difference);
  CHECK(parse_unit("degC^1")->to_si(20.0) == 293.15);
  CHECK((of("W/degC") * of("1/s")).per_difference);
  CHECK_FALSE((of("W/degC") * of("K")).per_difference);
  CHECK(meaning_name(of("W/degC")) == "W/delta_degC");
  CHECK(meaning_name(of("J/(kg degC)")) == "m^2/(s^2 delta_degC)");
  CHECK(meaning_name(of("degC")) == "temperature_K");
  CHECK(meaning_name(of("kHz")) == "Hz");
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

TEST_CASE("a unit with further factors is called no rate") {
  const Dimension per_period = of("Hz") * of("V s"), per_angle = of("V") * of("rad");
  CHECK(other_meaning(per_period, per_angle) ==
        "is in V period, but V rad is meant, and a period has 2*pi rad");
  CHECK(other_meaning(per_angle, per_period) ==
        "is in V rad, but V period is meant, and a period has 2*pi rad");
  CHECK(other_meaning_of_number(per_angle, per_period) == other_meaning(per_angle, per_period));
  const Dimension induced = of("V s") / of("rad") * of("Hz");  // of 20 mV s/rad at 50 Hz
  CHECK(other_meaning(induced, of("V s") / of("rad") * of("rad/s")) ==
        "is in V period/rad, but V is meant, and a period has 2*pi rad");
  CHECK(other_meaning(of("rad") / of("m"), of("Hz") * of("s") / of("m")) ==
        "is in rad/m, but period/m is meant, and a period has 2*pi rad");
}

TEST_CASE("a value with angles is divided by 2*pi for each angle that becomes a period") {
  CHECK(cure_of_rate(of("rad/s"), of("Hz")) == "divide by 2*pi");
  CHECK(cure_of_rate(of("Hz"), of("rpm")) == "multiply by 2*pi");
  CHECK(cure_of_rate(of("V s") / of("rad"), of("V") / of("Hz")) == "multiply by 2*pi");
  CHECK(cure_of_rate(of("rad/s") * of("rad/s"), of("Hz") * of("Hz")) == "divide by (2*pi)^2");
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
