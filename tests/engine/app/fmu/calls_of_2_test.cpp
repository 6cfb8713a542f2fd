// The binary of a unit of FMI 2, called as an importer calls it: well and badly.
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdarg>
#include <cstdio>
#include <vector>

#include "engine/base/fmi/fmi2.h"
#include "tests/engine/app/fmu/exported.hpp"

namespace stepwire::fmu {

namespace {

using Catch::Contains;

// x' = -k x, so that x(t) = exp(-k t).
const char* const decay_yaml = R"(stepwire: 1
title: a decay
step: 10 ms
stop: 1 s
solver: rk4
stop_when: x < 0.9
inputs: {push: {default: [0, 0]}}
parameters: {k: {value: 1, at_least: 0}}
blocks:
  slope: {block: Gain, u: x, gain: = -k}
  x:     {block: Integrator, u: slope, initial: 1}
  twice: {block: Gain, u: push, gain: 2}
record: [x, twice]
)";

/// References in the order of the description: each number has one.
enum Ref : fmi2ValueReference { time_, k, push_1, push_2, x, twice_1, twice_2, slope_of_x };

/// One binary for all tests of this file.
const Binary& binary() {
  static const Binary one("decay", decay_yaml, 2);
  return one;
}

#define CALL_2(name) binary().find<decltype(name)>(#name)

struct Unit {
  explicit Unit(fmi2Type type, const std::string& guid = binary().token()) {
    unit = CALL_2(fmi2Instantiate)("own name", type, guid.c_str(), "", &callbacks, fmi2False, fmi2False);
  }
  ~Unit() { CALL_2(fmi2FreeInstance)(unit); }
  Unit(const Unit&) = delete;

  static void log(fmi2ComponentEnvironment own, fmi2String name, fmi2Status, fmi2String, fmi2String format,
                  ...) {
    char text[500];
    va_list values;
    va_start(values, format);
    std::vsnprintf(text, sizeof text, format, values);
    va_end(values);
    static_cast<Unit*>(own)->message = std::string(name) + ": " + text;
  }
  fmi2Status set(fmi2ValueReference reference, double value) {
    return CALL_2(fmi2SetReal)(unit, &reference, 1, &value);
  }
  double get(fmi2ValueReference reference) {
    double value = NAN;
    CHECK(CALL_2(fmi2GetReal)(unit, &reference, 1, &value) == fmi2OK);
    return value;
  }
  void initialize() {
    REQUIRE(CALL_2(fmi2SetupExperiment)(unit, fmi2False, 0.0, 0.0, fmi2False, 0.0) == fmi2OK);
    REQUIRE(CALL_2(fmi2EnterInitializationMode)(unit) == fmi2OK);
    REQUIRE(CALL_2(fmi2ExitInitializationMode)(unit) == fmi2OK);
  }
  fmi2Status step(int tick, int ticks = 1) {
    return CALL_2(fmi2DoStep)(unit, 0.01 * tick, 0.01 * ticks, fmi2True);
  }

  std::string message;
  fmi2CallbackFunctions callbacks{log, nullptr, nullptr, nullptr, this};
  fmi2Component unit = nullptr;
};

/// Checks that a call failed because an argument was a null pointer.
void refuses(const Unit& unit, fmi2Status status, const std::string& argument) {
  INFO(argument);
  CHECK(status == fmi2Error);
  CHECK_THAT(unit.message, Contains(argument + " is a null pointer; it has to point to 1 value"));
}

}  // namespace

TEST_CASE("a unit of FMI 2 refuses a wrong GUID, missing instances and bad values with a sentence",
          "[full]") {
  if (!there_is_a_compiler()) return;
  const Unit wrong(fmi2CoSimulation, "{0}");
  CHECK(wrong.unit == nullptr);
  CHECK_THAT(wrong.message, Contains("own name: the GUID is not that of this unit"));
  CHECK(CALL_2(fmi2DoStep)(nullptr, 0.0, 0.01, fmi2True) == fmi2Error);
  Unit unit(fmi2CoSimulation);
  CHECK(unit.set(k, -1.0) == fmi2Error);
  CHECK_THAT(unit.message, Contains("k: must be at least 0"));
  CHECK(unit.step(0) == fmi2Error);
  CHECK_THAT(unit.message, Contains("DoStep is no call for a unit that is not initialized yet"));
  fmi2Integer whole = 1;
  const fmi2ValueReference reference = k;
  CHECK(CALL_2(fmi2GetInteger)(unit.unit, &reference, 1, &whole) == fmi2Error);
  CHECK_THAT(unit.message, Contains("no variables of the type Integer"));
}

TEST_CASE("a null pointer in a call of FMI 2 is an error that names the argument") {
  if (!there_is_a_compiler()) return;
  Unit unit(fmi2CoSimulation), exchange(fmi2ModelExchange);
  unit.initialize();
  exchange.initialize();
  const fmi2ValueReference reference = k;
  fmi2Boolean flag = fmi2True;
  double change = 7.0;
  refuses(unit, CALL_2(fmi2GetReal)(unit.unit, &reference, 1, nullptr), "values");
  refuses(unit, CALL_2(fmi2SetReal)(unit.unit, nullptr, 1, &change), "valueReferences");
  refuses(unit, CALL_2(fmi2GetFMUstate)(unit.unit, nullptr), "FMUState");
  refuses(unit, CALL_2(fmi2GetRealStatus)(unit.unit, fmi2LastSuccessfulTime, nullptr), "value");
  refuses(unit, CALL_2(fmi2GetBooleanStatus)(unit.unit, fmi2Terminated, nullptr), "value");
  refuses(exchange, CALL_2(fmi2NewDiscreteStates)(exchange.unit, nullptr), "eventInfo");
  const auto derivative = CALL_2(fmi2GetDirectionalDerivative);
  const fmi2ValueReference of = slope_of_x, by = x;
  refuses(exchange, derivative(exchange.unit, &of, 1, &by, 1, nullptr, &change), "seed");
  refuses(exchange, derivative(exchange.unit, &of, 1, nullptr, 1, &change, &change), "knowns");
  REQUIRE(CALL_2(fmi2EnterContinuousTimeMode)(exchange.unit) == fmi2OK);
  refuses(exchange, CALL_2(fmi2CompletedIntegratorStep)(exchange.unit, fmi2True, nullptr, &flag),
          "enterEventMode");
  CHECK((flag == fmi2True && change == 7.0));
}

TEST_CASE("a unit of FMI 2 steps by the equations, and can be reset") {
  if (!there_is_a_compiler()) return;
  Unit unit(fmi2CoSimulation);
  for (const double rate : {0.5, 0.25}) {
    REQUIRE(unit.set(k, rate) == fmi2OK);
    unit.initialize();
    REQUIRE(unit.set(push_2, 3.0) == fmi2OK);
    CHECK(unit.get(twice_1) == 0.0);
    CHECK(unit.get(twice_2) == 6.0);
    REQUIRE(unit.step(0, 10) == fmi2OK);
    CHECK(unit.get(x) == Approx(std::exp(-0.1 * rate)).epsilon(1e-9));
    REQUIRE(CALL_2(fmi2Reset)(unit.unit) == fmi2OK);
  }
  unit.initialize();
  CHECK(unit.get(k) == 1.0);
  CHECK(unit.get(twice_2) == 0.0);
}

TEST_CASE("a unit of FMI 2 discards the step behind its end, and says that it is over", "[full]") {
  if (!there_is_a_compiler()) return;
  Unit unit(fmi2CoSimulation);
  unit.initialize();
  CHECK(unit.step(0, 50) == fmi2Discard);
  fmi2Boolean over = fmi2False;
  fmi2Real last = 0.0;
  REQUIRE(CALL_2(fmi2GetBooleanStatus)(unit.unit, fmi2Terminated, &over) == fmi2OK);
  REQUIRE(CALL_2(fmi2GetRealStatus)(unit.unit, fmi2LastSuccessfulTime, &last) == fmi2OK);
  CHECK(over == fmi2True);
  CHECK(last == Approx(std::ceil(-std::log(0.9) / 0.01) * 0.01));
  CHECK(unit.get(x) < 0.9);
}

TEST_CASE("model exchange of FMI 2 has the slopes of the equations, and their derivatives", "[full]") {
  if (!there_is_a_compiler()) return;
  Unit unit(fmi2ModelExchange);
  unit.initialize();
  fmi2EventInfo info{};
  REQUIRE(CALL_2(fmi2NewDiscreteStates)(unit.unit, &info) == fmi2OK);
  CHECK(info.newDiscreteStatesNeeded == fmi2False);
  REQUIRE(CALL_2(fmi2EnterContinuousTimeMode)(unit.unit) == fmi2OK);
  const double state = 4.0;
  double slope = 0.0, change = 0.0;
  REQUIRE(CALL_2(fmi2SetContinuousStates)(unit.unit, &state, 1) == fmi2OK);
  REQUIRE(CALL_2(fmi2GetDerivatives)(unit.unit, &slope, 1) == fmi2OK);
  CHECK(slope == -4.0);
  const fmi2ValueReference of = slope_of_x, by = x;
  const double seed = 3.0;
  REQUIRE(CALL_2(fmi2GetDirectionalDerivative)(unit.unit, &of, 1, &by, 1, &seed, &change) == fmi2OK);
  CHECK(change == Approx(-3.0));
  CHECK(unit.set(k, 2.0) == fmi2Error);
  CHECK_THAT(unit.message, Contains("in event mode"));
  CHECK(unit.step(0) == fmi2Error);
}

}  // namespace stepwire::fmu
