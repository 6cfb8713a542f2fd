#include "tests/engine/view/plot/samples.hpp"

namespace stepwire::claim {
using namespace testing;

namespace {

unit::Dimension of(const char* unit) {
  return unit::parse_unit(unit)->dimension;
}

/// A signal without a known unit, twice a temperature where it is in kelvin.
query::RecordedName twice_a_room() {
  query::RecordedName name{"twice", {}, 0};
  name.zeros_if_kelvin = 2.0;
  return name;
}

query::SymbolTable rooms() {
  return {"d.yaml",
          {{"time", of("s"), {}},
           {"room", of("degC"), 0},
           {"gap", of("delta_degC"), 0},
           {"heat", of("K"), 0},
           {"speed", of("rpm"), 0},
           {"beat", of("Hz"), 0},
           {"guess", {}, 0},
           {"angle", of("deg"), 0},
           {"way", of("mm"), 0},
           {"damping", unit::Dimension{}, 0, {}, {}, {}, {}, {}, {}, true},
           {"slip", unit::Dimension{}, 0},
           twice_a_room()},
          {{"allowed", 273.25, of("degC"), "degC"}}};
}

/// The fault of a claim; an empty text where it has none.
std::string fault(const std::string& text) {
  const yaml::Document document = yaml::parse_document("- {that: a, " + text + "}", "d.yaml");
  yaml::Faults faults;
  static_cast<void>(read_claims(document.root, Claim::Kind::statement, rooms(), faults));
  const std::string all = all_text(faults);
  return all.empty() ? "" : all.substr(all.find(": ") + 2);
}

Claim claim(const std::string& text) {
  const yaml::Document document = yaml::parse_document("- {that: a, " + text + "}", "d.yaml");
  yaml::Faults faults;
  auto claims = read_claims(document.root, Claim::Kind::statement, rooms(), faults);
  INFO(all_text(faults));
  REQUIRE(faults.empty());
  return claims.at(0);
}

}  // namespace

TEST_CASE("a tolerance of a temperature is a difference, in kelvin") {
  CHECK(
      fault("final: room, equals: 150 degC, within: 0.1 degC") ==
      "claims.within: 0.1 degC is a temperature, but a difference of temperatures is meant; write it in K or "
      "delta_degC\n");
  CHECK(fault("final: heat, equals: 150 degC, within: 0.1 degF") != "");
  CHECK(fault("final: room, equals: 150 degC, within: $allowed") != "");
  CHECK(fault("final: room, equals: 150 degC, within: 1 %") != "");
  CHECK(claim("final: room, equals: 20 degC, within: 0.1 K").comparison.low == 293.15);
  CHECK(claim("final: room, equals: 20 degC, within: 0.1 delta_degC").comparison.within == 0.1);
  CHECK(claim("final: room, equals: 68 degF, within: 9 delta_degF").comparison.within == Approx(5.0));
}

TEST_CASE("a difference of temperatures is held against kelvin") {
  CHECK(fault("final: gap, at_most: 11 degC") != "");
  CHECK(fault("final: gap, at_most: 11 K").empty());
  CHECK(fault("max: abs(room - 20 degC), at_most: 11 degC") != "");
  CHECK(fault("max: abs(room - 20 degC), at_most: 11 K").empty());
  CHECK(fault("spread: room, at_most: 11 degC") != "");
  CHECK(fault("rms: heat, at_most: 11 degC") != "");
  CHECK(fault("final: room, at_most: 11 delta_degC") != "");
  CHECK(fault("max: room + gap, at_most: 30 degC").empty());
  CHECK(fault("max: room + room, at_most: 600 K") != "");
  CHECK(fault("max: (room + room)/2, at_most: 30 degC").empty());
  CHECK(fault("fraction: gap > 10 degC, at_most: 10 %") != "");
  CHECK(fault("fraction: room > 10 degC, at_most: 10 %").empty());
}

TEST_CASE("what is at fault is named: a sum, a share or a divisor") {
  CHECK(fault("final: room/2, at_most: 20 degC") ==
        "claims.at_most: the claim's value adds or scales temperatures in degC, whose zero is none; subtract "
        "them, or take their mean\n");
  CHECK_THAT(fault("final: gap/1 degC, at_most: 2"),
             Catch::Contains("write a difference in K or delta_degC"));
  CHECK_THAT(fault("final: room/(1 degC), at_most: 2"), Catch::Contains("behind '/'"));
  CHECK(fault("final: gap/1 K, at_most: 2").empty());
  CHECK(fault("fit: [room, gap], at_least: 90") != "");
  CHECK(fault("final: speed + beat, at_most: 100 rad/s") != "");
}

TEST_CASE("twice a temperature is shown in no degC, half of it is") {
  // 2 * 293.15 K is no 40 degC, which is 313.15 K.
  CHECK_THAT(
      fault("final: twice in degC, at_most: 40 degC"),
      Catch::Contains("'twice' adds or scales temperatures in degC") && Catch::Contains("take their mean"));
  CHECK(fault("final: twice/2 in degC, at_most: 40 degC").empty());
  CHECK(fault("final: twice in K, at_most: 600 K") != "");
  CHECK(fault("final: twice in V, at_most: 600 V").empty());
  CHECK(fault("final: guess in degC, at_most: 40 degC").empty());
}

TEST_CASE("a parameter in degC is shown in degC") {
  CHECK(claim("final: room, equals: $allowed").comparison.unit == "degC");
  CHECK(claim("final: room, equals: allowed").comparison.low == 273.25);
}

TEST_CASE("turns per time are held against no frequency") {
  CHECK(fault("final: speed, equals: 1 Hz") ==
        "claims.equals: 1 Hz counts periods per time, of which each has 2*pi rad; write it in rad/s\n");
  CHECK(fault("final: beat, equals: 60 rpm") ==
        "claims.equals: 60 rpm is an angle per time, and a period has 2*pi rad; write it in Hz\n");
  CHECK(fault("final: speed, equals: 60 rpm").empty());
  CHECK(fault("final: speed, equals: 6.28 1/s").empty());
  CHECK(fault("final: speed/(2*pi), equals: 1 Hz").empty());
  CHECK(fault("final: 2*pi*beat, equals: 60 rpm").empty());
}

TEST_CASE("a number with a unit is held against no value without one") {
  CHECK(fault("final: guess, equals: 50 mm") ==
        "claims.equals: 50 mm has a unit, but that of 'guess' is not known; name its SI unit behind it, as "
        "'guess in m', or in the head units: {guess: m}\n");
  CHECK_THAT(fault("final: guess, equals: 2 N"),
             Catch::Contains("'guess in N', or in the head units: {guess: N}"));
  CHECK_THAT(fault("iae: guess, at_most: 2 N s"), Catch::Contains("'guess in N'"));
  CHECK(fault("final: guess, equals: 0.05").empty());
  const Claim in_mm = claim("final: guess in mm, equals: 50 mm");
  CHECK(in_mm.comparison.low == 0.05);
  CHECK(in_mm.comparison.unit == "mm");
  CHECK(fault("final: guess in mm, equals: 50") ==
        "claims.equals: 50 has no unit, but the value is in mm; write 50 mm\n");
  CHECK(fault("final: guess in mm, equals: 0, within: 1 mm").empty());
  CHECK(fault("final: guess in m, equals: 3 N") != "");
  CHECK(fault("quantile_of_runs: {share: 50 %, value: max(guess)}, at_most: 3 N") != "");
  CHECK(fault("quantile_of_runs: {share: 50 %, value: max(guess) in N}, at_most: 3 N").empty());
  CHECK(fault("quantile_of_runs: {share: 50 %, value: max(guess) in N}, at_most: 3 m") != "");
  CHECK(fault("quantile_of_runs: {share: 50 %, value: max(speed) in Hz}, at_most: 3 Hz") != "");
}

TEST_CASE("a tolerance without unit is refused where the value is in a unit other than SI") {
  CHECK(fault("final: guess in mm, equals: 50 mm, within: 1") ==
        "claims.within: 1 has no unit, but the value is in mm; write 1 mm\n");
  CHECK(fault("final: speed, equals: 60 rpm, within: 1") ==
        "claims.within: 1 has no unit, but the value is in rpm; write 1 rpm\n");
  CHECK(fault("final: speed, between: [-4, 60 rpm]") ==
        "claims.between: -4 has no unit, but the value is in rpm; write -4 rpm\n");
  CHECK(fault("final: guess in mm, equals: 50 mm, within: 1 %").empty());
  CHECK(fault("final: guess in mm, equals: 50 mm, within: 0").empty());
  CHECK(fault("final: guess in m, equals: 50 mm, within: 1e-3").empty());
  CHECK(fault("final: guess in degC, equals: 20 degC, within: 0.1").empty());
  CHECK_THAT(fault("final: guess in degF, equals: 68 degF, within: 0.1"),
             Catch::Contains("write 0.1 delta_degF"));
}

TEST_CASE("the unit of a reduced value follows from the reduction and the unit of its signal") {
  const auto shown = [](const std::string& text, double value) { return value_text(claim(text), value); };
  CHECK(shown("rise_time: angle in deg, at_most: 1 s", 0.8) == "0.8 s");
  CHECK(shown("settling_time: way in mm, at_most: 0.1", 0.05) == "0.05 s");
  CHECK(shown("peak_time: angle in deg, at_most: 2 s", 1.0) == "1 s");
  CHECK(shown("rise_time: room in degC, at_most: 100 ms", 0.008) == "0.008 s");
  CHECK(shown("iae: angle in deg, at_most: 100 deg s", 0.7853981633974483) == "45 deg s");
  CHECK(shown("iae: way in mm, at_most: 9 mm s", 0.004) == "4 mm s");
  CHECK(shown("iae: room in degC, at_most: 9 K s", 4.0) == "4 K s");
  CHECK(shown("spread: room in degC, at_most: 6 K", 5.0) == "5 K");
  CHECK(shown("spread: room in degF, at_most: 6 K", 5.0) == "9 delta_degF");
  CHECK(shown("steady_error: room in degC, at_most: 6 K", 5.0) == "5 K");
  CHECK(shown("rms: room in degC, at_most: 600 K", 300.0) == "300 K");
  CHECK(shown("spread: way in mm, at_most: 6 mm", 0.005) == "5 mm");
  CHECK(shown("overshoot: angle in deg, at_most: 0.05", 0.04) == "0.04");
  CHECK(shown("overshoot: damping in %, at_most: 5 %", 0.04) == "4 %");
  CHECK(shown("fraction: way > 1 mm in %, at_least: 10 %", 0.495) == "49.5 %");
  CHECK(shown("rising: {value: way in mm, over: time}, at_least: 0.9", 1.0) == "1");
  CHECK(shown("fit: [way in mm, way in mm], at_least: 90", 95.0) == "95 %");
  CHECK(fault("rms: room in degC, at_most: 25 degC") != "");
  CHECK(fault("iae: angle in deg, at_most: 1 deg") != "");
  CHECK_THAT(fault("rise_time: angle in deg, at_most: 1 deg"),
             Catch::Contains("but the claim's value is in s"));
}

TEST_CASE("a unit behind a condition is refused") {
  CHECK(fault("fraction: angle > 45 deg in deg, at_least: 10 %") ==
        "claims.fraction: 'angle > 45 deg' is a condition, which has no unit; leave out 'in deg'\n");
  CHECK(fault("count: angle > 45 deg in deg, at_least: 1") != "");
  CHECK(fault("fraction_of_runs: max(angle) > 45 deg in deg, at_least: 10 %") != "");
}

TEST_CASE("a unit in the sentence of a claim has the meaning of the value") {
  const auto document =
      yaml::parse_document("- {that: it rises by 5 degC or 5 K, spread: room, at_most: 6}", "d.yaml");
  yaml::Faults faults;
  const auto claims = read_claims(document.root, Claim::Kind::statement, rooms(), faults);
  CHECK(value_text(claims.at(0), 5.0) == "5 K");
}

TEST_CASE("a share, a count or a damping ratio is held against no angle") {
  CHECK(fault("overshoot: slip, at_most: 5 deg") ==
        "claims.at_most: 5 deg is in deg, but the claim's value has no unit; write a number without unit\n");
  CHECK(fault("overshoot: angle, at_most: 5 deg") != "");
  CHECK(fault("fraction: angle > 0, at_most: 0.1 rad") != "");
  CHECK(fault("count: angle > 0, at_most: 5 deg") != "");
  CHECK(fault("rising: {value: angle, over: time}, at_least: 5 deg") != "");
  CHECK(fault("fit: [angle, angle], at_least: 5 deg") != "");
  CHECK(fault("fraction_of_runs: max(angle) > 0, at_most: 5 deg") != "");
  CHECK(fault("quantile_of_runs: {share: 50 %, value: overshoot(angle)}, at_most: 5 deg") != "");
  CHECK(fault("quantile_of_runs: {share: 50 %, value: max(angle)}, at_most: 5 deg").empty());
  CHECK(fault("quantile: {share: 5 deg, value: angle}, at_most: 5 deg") != "");
  CHECK(fault("final: 2*damping, at_least: 5 deg") != "");
  CHECK(fault("final: damping, equals: 1, within: 1 deg") != "");
  CHECK_THAT(fault("final: damping in deg, at_least: 5 deg"),
             Catch::Contains("'damping' is a pure number and cannot be drawn in deg"));
  CHECK(fault("final: damping, at_least: 5 %").empty());
  // Radians are a number, so a quotient of two lengths may be an angle.
  CHECK(fault("final: acos(damping), at_least: 5 deg").empty());
  CHECK(fault("final: slip, at_least: 5 deg").empty());
  CHECK(fault("final: angle, at_least: 5 deg").empty());
}

TEST_CASE("an angle is held against no share") {
  CHECK(fault("final: angle, at_most: 5 %") ==
        "claims.at_most: 5 % is a share, but the claim's value is an angle; write it in deg or rad\n");
  CHECK(fault("final: angle, equals: 5 deg, within: 5 %").empty());
  CHECK(fault("final: slip, at_most: 5 %").empty());
}

}  // namespace stepwire::claim
