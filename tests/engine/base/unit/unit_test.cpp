#include "engine/base/unit/unit.hpp"

#include <catch2/catch.hpp>
#include <numbers>
#include <string>
#include <thread>
#include <vector>

namespace stepwire::unit {

namespace {

constexpr double pi = std::numbers::pi;
const Dimension none{};
const Dimension length{{1}};
const Dimension force{{1, 1, -2}};
const Dimension torque{{2, 1, -2}};
const Dimension speed{{1, 0, -1}};
const Dimension rate{{0, 0, -1}};

Unit unit(const std::string& text) {
  INFO(text);
  const auto result = parse_unit(text);
  REQUIRE(result);
  return *result;
}

}  // namespace

TEST_CASE("units of the thesis become SI by their published factors") {
  struct Known {
    const char* text;
    double value, si;
    Dimension dimension;
  };
  // International foot and pound (1959), standard gravity (CGPM 1901), SI prefixes.
  const Known known[] = {
      {"mm", 5.0, 0.005, length},
      {"mm/s", 10.0, 0.01, speed},
      {"in", 1.0, 0.0254, length},
      {"lbf", 1.0, 4.4482216152605, force},
      {"lbf.in", 1.0, 0.1129848290276167, torque},
      {"N m", 2.0, 2.0, torque},
      {"N.m", 2.0, 2.0, torque},
      {"N*m", 2.0, 2.0, torque},
      {"Nm", 2.0, 2.0, torque},
      {"mNm", 2.0, 0.002, torque},
      {"N s/m", 3.0, 3.0, {{0, 1, -1}}},
      {"N/mm", 0.5, 500.0, {{0, 1, -2}}},
      {"A/mm", 0.07, 70.0, {{-1, 0, 0, 1}}},
      {"%", 5.0, 0.05, none},
      {"", 7.0, 7.0, none},
      {"1", 7.0, 7.0, none},
      {"1/s", 5.0, 5.0, rate},
      {"s-1", 5.0, 5.0, rate},
      {"kHz", 1.0, 1000.0, rate},
      {"us", 3.0, 3e-6, {{0, 0, 1}}},
      {"µs", 3.0, 3e-6, {{0, 0, 1}}},
      {"min", 2.0, 120.0, {{0, 0, 1}}},
      {"h", 2.0, 7200.0, {{0, 0, 1}}},
      {"km/h", 36.0, 10.0, speed},
      {"kph", 36.0, 10.0, speed},
      {"mph", 1.0, 0.44704, speed},
      {"knot", 3600.0, 1852.0, speed},
      {"m^2", 2.0, 2.0, {{2}}},
      {"mm2", 3.0, 3e-6, {{2}}},
      {"mm²", 3.0, 3e-6, {{2}}},
      {"m^0.5", 2.0, 2.0, {{0.5}}},
      {"J/(kg K)", 4186.0, 4186.0, {{2, 0, -2, 0, -1}}},
      {"kg m^2/s^3/A", 1.0, 1.0, {{2, 1, -3, -1}}},
      {"ohm", 1.0, 1.0, {{2, 1, -3, -2}}},
      {"bar", 1.0, 1e5, {{-1, 1, -2}}},
      {"g", 5.0, 0.005, {{0, 1}}},
      {"t", 1.0, 1000.0, {{0, 1}}},
  };
  for (const Known& k : known) {
    INFO(k.text);
    const Unit u = unit(k.text);
    CHECK(u.to_si(k.value) == k.si);
    CHECK(u.from_si(k.si) == k.value);
    CHECK(u.dimension == k.dimension);
  }
}

TEST_CASE("an angle has no dimension") {
  CHECK(unit("rad").dimension == none);
  CHECK(unit("deg").dimension == none);
  CHECK(unit("rpm").dimension == rate);
  CHECK(unit("N m/rad").dimension == torque);
  CHECK(unit("deg").to_si(180.0) == pi);
  CHECK(unit("degree").to_si(90.0) == pi / 2);
  CHECK(unit("°").to_si(360.0) == 2 * pi);
  CHECK(unit("deg").from_si(pi) == 180.0);
  CHECK(unit("rev").to_si(1.0) == 2 * pi);
  CHECK(unit("rev/min").to_si(60.0) == Approx(2 * pi).epsilon(1e-15));
  CHECK(unit("rpm").to_si(30.0) == Approx(pi).epsilon(1e-15));
  CHECK(unit("mrad").to_si(1.0) == 0.001);
}

TEST_CASE("a temperature has an offset where it stands alone and none in a product") {
  CHECK(unit("degC").to_si(20.0) == 293.15);
  CHECK(unit("degC").from_si(273.15) == 0.0);
  CHECK(unit("degF").to_si(212.0) == 373.15);
  CHECK(unit("W/degC").to_si(3.0) == 3.0);
  CHECK(unit("W/degC").dimension == unit("W/K").dimension);
}

TEST_CASE("every decimal of three digits arrives at its nearest double") {
  const Unit milli = unit("ms");
  const Unit inch = unit("in");
  for (int i = 1; i < 1000; ++i) {
    const std::string digits = std::to_string(i);
    CHECK(milli.to_si(std::stod(digits + "e-2")) == std::stod(digits + "e-5"));
    CHECK(inch.to_si(i) == std::stod(std::to_string(i * 254) + "e-4"));
    CHECK(milli.from_si(std::stod(digits + "e-5")) == std::stod(digits + "e-2"));
  }
}

TEST_CASE("what is no unit is refused") {
  for (const char* text : {"taw",   "e",
                           "pi",    "u",
                           "2 m",   "m 2",
                           "m/",    "/s",
                           "m//s",  "m^",
                           "m^x",   "m^0",
                           "m0",    "(m",
                           "m)",    "()",
                           "N-m",   "m+m",
                           "dBZ",   "lg(re 1 mW)",
                           "s@1.0", "5",
                           "1 1/s", "m^1e99",
                           "m^nan", "hours since 2000-01-01",
                           ".",     "%%",
                           "m\n"}) {
    INFO(text);
    CHECK_FALSE(parse_unit(text));
  }
  CHECK_FALSE(parse_unit(std::string(100'000, 'm')));
  CHECK_FALSE(parse_unit(std::string(150, '(') + "m" + std::string(150, ')')));
  CHECK_FALSE(parse_unit(std::string("m\0s", 3)));
}

TEST_CASE("units are read from several threads at once") {
  std::vector<std::thread> threads;
  std::vector<int> good(4, 0);
  for (std::size_t t = 0; t < good.size(); ++t) {
    threads.emplace_back([&good, t] {
      for (int i = 0; i < 200; ++i) good[t] += parse_unit("lbf.in/ms")->dimension == torque * rate ? 1 : 0;
    });
  }
  for (std::thread& thread : threads) thread.join();
  CHECK(good == std::vector<int>(4, 200));
}

}  // namespace stepwire::unit
