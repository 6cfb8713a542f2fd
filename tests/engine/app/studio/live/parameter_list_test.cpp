// The list of parameters from which the page makes its sliders.
#include <set>

#include "tests/engine/app/studio/live/live_studio.hpp"

namespace stepwire::live {

namespace {

const std::string units = R"(stepwire: 1
title: Units of a file
step: 1 ms
stop: 1 s
solver: rk4
parameters:
  length: {value: 10 mm, at_most: 30 mm}
  zero: {value: 0 deg}
  flat: {value: 0 mm}
  twice: {value: =2*length}
  limited: {value: 5 mm, at_most: $length}
  warm: {value: 21 degC}
  share: 5 %
blocks:
  a: {block: Constant, value: $length}
  b: {block: Constant, value: =2*length}
  c: {block: Constant, value: 30 mm}
  d: {block: Constant, value: 0 mm}
  e: {block: Constant, value: $twice}
  f: {block: Constant, value: $zero}
  g: {block: Sine, frequency: 50 Hz, phase: 10 deg}
  h: {block: Constant, value: $flat}
  i: {block: Constant, value: $limited}
  j: {block: Constant, value: $warm}
  k: {block: Constant, value: $share}
  l: {block: Constant, value: 900 rpm}
  m: {block: Constant, value: 1e-3 m}
record: [a, b, c, d, e, f, g, h, i, j, k, l, m]
)";

std::map<std::string, Json> listed(const std::string& text) {
  Studio studio(text);
  const Json loaded = studio.call("run.load", R"({"file": 1})");
  std::map<std::string, Json> all;
  for (const Json& one : loaded.find("parameters")->items()) {
    INFO(one.text());
    CHECK(all.emplace(*one.find("name")->as_text(), one).second);
  }
  return all;
}

std::string unit_of(const Json& parameter) {
  return *parameter.find("shown")->find("text")->as_text();
}

double number(const Json& parameter, const char* key) {
  return *parameter.find(key)->as_number();
}

/// A number in the unit in which it is shown.
double shown(const Json& parameter, const char* key) {
  const Json& unit = *parameter.find("shown");
  return number(parameter, key) * number(unit, "scale") + number(unit, "offset");
}

}  // namespace

TEST_CASE("a number has one slider, that of the parameter from which it follows") {
  const auto all = listed(units);
  for (const std::string name : {"length", "zero", "flat", "limited", "warm", "share", "c.value", "d.value"})
    CHECK(all.contains(name));
  for (const std::string name :
       {"twice", "a.value", "b.value", "e.value", "f.value", "h.value", "i.value", "j.value", "k.value"}) {
    INFO(name);
    CHECK_FALSE(all.contains(name));
  }
}

TEST_CASE("a number is shown in the unit of the file, also a zero") {
  const auto all = listed(units);
  CHECK(unit_of(all.at("length")) == "mm");
  CHECK(number(all.at("length"), "value") == Approx(0.01));
  CHECK(shown(all.at("length"), "value") == Approx(10.0));
  CHECK(shown(all.at("length"), "high") == Approx(30.0));
  CHECK(unit_of(all.at("zero")) == "deg");
  CHECK(shown(all.at("zero"), "low") == Approx(-10.0));
  CHECK(number(all.at("zero"), "high") == Approx(0.17453292519943295));
  CHECK(unit_of(all.at("flat")) == "mm");
  CHECK(unit_of(all.at("d.value")) == "mm");
  CHECK(shown(all.at("warm"), "value") == Approx(21.0));
  CHECK(number(all.at("warm"), "value") == Approx(294.15));
  CHECK(shown(all.at("warm"), "low") == Approx(0.0).margin(1e-9));
  CHECK(shown(all.at("warm"), "high") == Approx(42.0));
  CHECK(unit_of(all.at("share")) == "%");
  CHECK(shown(all.at("share"), "value") == Approx(5.0));
}

TEST_CASE("numbers of blocks have the unit of the file, and defaults that of their declaration") {
  const auto all = listed(units);
  CHECK(unit_of(all.at("c.value")) == "mm");
  CHECK(*all.at("c.value").find("text")->as_text() == "30 mm");
  CHECK(unit_of(all.at("g.frequency")) == "Hz");
  CHECK(shown(all.at("g.frequency"), "value") == Approx(50.0));
  CHECK(unit_of(all.at("g.phase")) == "deg");
  CHECK(shown(all.at("g.phase"), "value") == Approx(10.0));
  CHECK(unit_of(all.at("l.value")) == "rpm");
  CHECK(shown(all.at("l.value"), "value") == Approx(900.0));
  CHECK(unit_of(all.at("m.value")) == "m");
  CHECK(number(all.at("m.value"), "value") == 1e-3);
}

}  // namespace stepwire::live
