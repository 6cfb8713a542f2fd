// The binary of an exported unit, called as an importer calls it: well and badly.
#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

#include "engine/base/fmi/fmi3.h"
#include "tests/engine/app/fmu/exported.hpp"

namespace stepwire::fmu {

namespace {

using Catch::Contains;

const char* const cart_yaml = R"(stepwire: 1
title: a cart that is pushed
step: 10 ms
stop: 1 s
solver: rk4
inputs: {push: {unit: N, default: 1 N}}
parameters:
  mass: {value: 2 kg, above: 0 kg}
  k: 8 N/m
blocks:
  spring: {block: Gain, u: cart.position, gain: "= -k"}
  net:    {block: Sum, u: [spring, push]}
  cart:   {block: Mass, force: net, mass: $mass, initial_position: 0.5 m}
  both:   {block: Mux, u: [push, net]}
  guard:  {block: Assert, u: near}
  near:   {block: Expression, expression: "u1 < u2 ? 1 : 0", u: [cart.position, 3 m]}
record: [cart.position, net, both]
)";

/// References in the order of the description.
enum Ref : fmi3ValueReference { time_, mass, k, push, position, net, both, slope_of_position, velocity };

/// One binary for all tests of this file.
const Binary& binary() {
  static const Binary one("cart", cart_yaml, 3);
  return one;
}

#define CALL(name) binary().find<decltype(name)>(#name)

struct Unit {
  explicit Unit(bool exchange = false, const std::string& token = binary().token()) {
    unit = exchange ? CALL(fmi3InstantiateModelExchange)("a", token.c_str(), "", false, false, this, log)
                    : CALL(fmi3InstantiateCoSimulation)("a", token.c_str(), "", false, false, false, false,
                                                        nullptr, 0, this, log, nullptr);
  }
  ~Unit() { CALL(fmi3FreeInstance)(unit); }
  Unit(const Unit&) = delete;

  static void log(fmi3InstanceEnvironment own, fmi3Status, fmi3String, fmi3String text) {
    static_cast<Unit*>(own)->message = text;
  }
  fmi3Status set(fmi3ValueReference reference, double value) {
    return CALL(fmi3SetFloat64)(unit, &reference, 1, &value, 1);
  }
  double get(fmi3ValueReference reference) {
    double value = NAN;
    CHECK(CALL(fmi3GetFloat64)(unit, &reference, 1, &value, 1) == fmi3OK);
    return value;
  }
  void initialize() {
    REQUIRE(CALL(fmi3EnterInitializationMode)(unit, false, 0.0, 0.0, false, 0.0) == fmi3OK);
    REQUIRE(CALL(fmi3ExitInitializationMode)(unit) == fmi3OK);
  }
  fmi3Status step(double time, double length = 0.01) {
    bool event, terminate, early;
    double last;
    return CALL(fmi3DoStep)(unit, time, length, true, &event, &terminate, &early, &last);
  }
  void run(int from, int to) {
    for (int tick = from; tick < to; ++tick) REQUIRE(step(0.01 * tick) == fmi3OK);
  }

  fmi3Instance unit = nullptr;
  std::string message;
};

/// Checks that a call failed because an argument was a null pointer.
void refuses(const Unit& unit, fmi3Status status, const std::string& argument) {
  INFO(argument);
  CHECK(status == fmi3Error);
  CHECK_THAT(unit.message, Contains(argument + " is a null pointer; it has to point to "));
}

}  // namespace

TEST_CASE("a wrong token and a missing instance are errors", "[full]") {
  if (!there_is_a_compiler()) return;
  const Unit wrong(false, "{0}");
  CHECK(wrong.unit == nullptr);
  CHECK_THAT(wrong.message, Contains("token is not that of this unit"));
  double value = 0.0;
  const fmi3ValueReference reference = mass;
  CHECK(CALL(fmi3GetFloat64)(nullptr, &reference, 1, &value, 1) == fmi3Error);
  CHECK(CALL(fmi3DoStep)(nullptr, 0.0, 0.01, true, nullptr, nullptr, nullptr, nullptr) == fmi3Error);
  CHECK(CALL(fmi3Reset)(nullptr) == fmi3Error);
}

TEST_CASE("a parameter out of its range is refused with the file's bound, and the former value holds",
          "[full]") {
  if (!there_is_a_compiler()) return;
  Unit cart;
  CHECK(cart.set(mass, 4.0) == fmi3OK);
  CHECK(cart.set(mass, -1.0) == fmi3Error);
  CHECK_THAT(cart.message, Contains("mass: must be above 0 kg"));
  cart.initialize();
  CHECK(cart.get(mass) == 4.0);
  CHECK(cart.set(mass, NAN) == fmi3Error);
  CHECK(cart.step(0.0) == fmi3OK);
}

TEST_CASE("calls in the wrong state, of wrong variables and of wrong sizes are errors with a sentence",
          "[full]") {
  if (!there_is_a_compiler()) return;
  Unit cart;
  CHECK(cart.step(0.0) == fmi3Error);
  CHECK_THAT(cart.message, Contains("DoStep is no call for a unit that is not initialized yet"));
  cart.initialize();
  CHECK(cart.set(net, 1.0) == fmi3Error);
  CHECK_THAT(cart.message, Contains("net is neither an input nor a parameter"));
  CHECK(cart.set(99, 1.0) == fmi3Error);
  CHECK_THAT(cart.message, Contains("no variable with the value reference 99"));
  CHECK(cart.step(0.5) == fmi3Error);
  CHECK_THAT(cart.message, Contains("it stands at 0 s"));
  CHECK(cart.step(0.0, 0.015) == fmi3Error);
  CHECK_THAT(cart.message, Contains("no whole number of its steps of 0.01 s"));
  double states[2];
  CHECK(CALL(fmi3GetContinuousStates)(cart.unit, states, 2) == fmi3Error);
  double one = 0.0;
  const fmi3ValueReference pair = both;
  CHECK(CALL(fmi3GetFloat64)(cart.unit, &pair, 1, &one, 1) == fmi3Error);
  CHECK_THAT(cart.message, Contains("2 numbers, not 1"));
  fmi3FMUState state = nullptr;
  const fmi3Byte wrong[8] = {};
  CHECK(CALL(fmi3DeserializeFMUState)(cart.unit, wrong, sizeof wrong, &state) == fmi3Error);
  CHECK_THAT(cart.message, Contains("no state of this unit"));
  CHECK(CALL(fmi3Terminate)(cart.unit) == fmi3OK);
  CHECK(cart.step(0.0) == fmi3Error);
}

TEST_CASE("a null pointer for a result is an error that names the argument, and nothing is written") {
  if (!there_is_a_compiler()) return;
  Unit cart, exchange(true);
  cart.initialize();
  exchange.initialize();
  double last = 7.0;
  bool flag = true;
  const auto step = CALL(fmi3DoStep);
  const auto update = CALL(fmi3UpdateDiscreteStates);
  refuses(cart, step(cart.unit, 0.0, 0.01, true, nullptr, &flag, &flag, &last), "eventHandlingNeeded");
  refuses(cart, step(cart.unit, 0.0, 0.01, true, &flag, nullptr, &flag, &last), "terminateSimulation");
  refuses(cart, step(cart.unit, 0.0, 0.01, true, &flag, &flag, nullptr, &last), "earlyReturn");
  refuses(cart, step(cart.unit, 0.0, 0.01, true, &flag, &flag, &flag, nullptr), "lastSuccessfulTime");
  refuses(cart, CALL(fmi3GetNumberOfContinuousStates)(cart.unit, nullptr), "nContinuousStates");
  refuses(exchange, update(exchange.unit, &flag, &flag, &flag, &flag, &flag, nullptr), "nextEventTime");
  refuses(exchange, update(exchange.unit, nullptr, &flag, &flag, &flag, &flag, &last),
          "discreteStatesNeedUpdate");
  REQUIRE(CALL(fmi3EnterContinuousTimeMode)(exchange.unit) == fmi3OK);
  refuses(exchange, CALL(fmi3CompletedIntegratorStep)(exchange.unit, true, &flag, nullptr),
          "terminateSimulation");
  CHECK((flag && last == 7.0));
  CHECK(cart.get(time_) == 0.0);
}

TEST_CASE("a null pointer for numbers is an error that names the argument, unless there are none") {
  if (!there_is_a_compiler()) return;
  Unit cart, exchange(true);
  cart.initialize();
  exchange.initialize();
  const fmi3ValueReference pair = both;
  double values[2] = {7.0, 7.0};
  refuses(cart, CALL(fmi3GetFloat64)(cart.unit, nullptr, 1, values, 2), "valueReferences");
  refuses(cart, CALL(fmi3GetFloat64)(cart.unit, &pair, 1, nullptr, 2), "values");
  refuses(cart, CALL(fmi3SetFloat64)(cart.unit, &pair, 1, nullptr, 2), "values");
  refuses(exchange, CALL(fmi3GetContinuousStates)(exchange.unit, nullptr, 2), "continuousStates");
  refuses(exchange, CALL(fmi3SetContinuousStates)(exchange.unit, nullptr, 2), "continuousStates");
  refuses(exchange, CALL(fmi3GetContinuousStateDerivatives)(exchange.unit, nullptr, 2), "derivatives");
  refuses(exchange, CALL(fmi3GetNominalsOfContinuousStates)(exchange.unit, nullptr, 2), "nominals");
  CHECK((values[0] == 7.0 && values[1] == 7.0));
  CHECK(CALL(fmi3GetEventIndicators)(exchange.unit, nullptr, 0) == fmi3OK);
}

TEST_CASE("a null pointer for a state is an error that names the argument; freeing none is none") {
  if (!there_is_a_compiler()) return;
  Unit cart;
  cart.initialize();
  std::size_t size = 0;
  fmi3FMUState state = nullptr;
  REQUIRE(CALL(fmi3GetFMUState)(cart.unit, &state) == fmi3OK);
  REQUIRE(CALL(fmi3SerializedFMUStateSize)(cart.unit, state, &size) == fmi3OK);
  refuses(cart, CALL(fmi3GetFMUState)(cart.unit, nullptr), "FMUState");
  refuses(cart, CALL(fmi3SetFMUState)(cart.unit, nullptr), "FMUState");
  refuses(cart, CALL(fmi3SerializedFMUStateSize)(cart.unit, state, nullptr), "size");
  refuses(cart, CALL(fmi3SerializeFMUState)(cart.unit, state, nullptr, size), "serializedState");
  refuses(cart, CALL(fmi3DeserializeFMUState)(cart.unit, nullptr, size, &state), "serializedState");
  CHECK(CALL(fmi3FreeFMUState)(cart.unit, &state) == fmi3OK);
  CHECK(CALL(fmi3FreeFMUState)(cart.unit, nullptr) == fmi3OK);
}

TEST_CASE("a wrong count of numbers is an error, and nothing is written behind the states") {
  if (!there_is_a_compiler()) return;
  Unit exchange(true);
  exchange.initialize();
  double numbers[3] = {7.0, 7.0, 7.0};
  CHECK(CALL(fmi3GetNominalsOfContinuousStates)(exchange.unit, numbers, 3) == fmi3Error);
  CHECK_THAT(exchange.message, Contains("it has 2 continuous states, not 3"));
  CHECK(CALL(fmi3GetContinuousStates)(exchange.unit, numbers, 3) == fmi3Error);
  CHECK(CALL(fmi3GetContinuousStateDerivatives)(exchange.unit, numbers, 1) == fmi3Error);
  CHECK((numbers[0] == 7.0 && numbers[1] == 7.0 && numbers[2] == 7.0));
  REQUIRE(CALL(fmi3GetNominalsOfContinuousStates)(exchange.unit, numbers, 2) == fmi3OK);
  CHECK((numbers[0] == 1.0 && numbers[1] == 1.0 && numbers[2] == 7.0));
}

TEST_CASE("what a block finds wrong ends the run with its sentence, until the unit is reset") {
  if (!there_is_a_compiler()) return;
  Unit cart;
  cart.initialize();
  REQUIRE(cart.set(push, 1e4) == fmi3OK);
  fmi3Status status = fmi3OK;
  int tick = 0;
  for (; tick < 100 && status == fmi3OK; ++tick) status = cart.step(0.01 * tick);
  CHECK(status == fmi3Error);
  CHECK_THAT(cart.message, Contains("guard"));
  CHECK(cart.step(0.01 * tick) == fmi3Error);
  CHECK(CALL(fmi3Reset)(cart.unit) == fmi3OK);
  cart.initialize();
  CHECK(cart.get(push) == 1.0);
  CHECK(cart.get(position) == 0.5);
  CHECK(cart.step(0.0) == fmi3OK);
}

TEST_CASE("two instances in one process have nothing in common") {
  if (!there_is_a_compiler()) return;
  Unit light, heavy;
  REQUIRE(heavy.set(mass, 200.0) == fmi3OK);
  light.initialize();
  heavy.initialize();
  light.run(0, 20);
  const double before = heavy.get(position);
  CHECK(before == 0.5);
  heavy.run(0, 20);
  CHECK(std::fabs(heavy.get(position) - 0.5) < 0.01);
  CHECK(std::fabs(light.get(position) - 0.5) > 0.01);
}

TEST_CASE("a state that was saved and serialized goes on with the same bits in another instance as well",
          "[full]") {
  if (!there_is_a_compiler()) return;
  Unit cart, other;
  cart.initialize();
  other.initialize();
  cart.run(0, 10);
  REQUIRE(cart.set(push, 5.0) == fmi3OK);
  REQUIRE(cart.set(mass, 3.0) == fmi3OK);
  fmi3FMUState state = nullptr;
  REQUIRE(CALL(fmi3GetFMUState)(cart.unit, &state) == fmi3OK);
  std::size_t size = 0;
  REQUIRE(CALL(fmi3SerializedFMUStateSize)(cart.unit, state, &size) == fmi3OK);
  std::vector<fmi3Byte> bytes(size);
  REQUIRE(CALL(fmi3SerializeFMUState)(cart.unit, state, bytes.data(), size) == fmi3OK);
  cart.run(10, 50);
  const double first = cart.get(position);
  REQUIRE(CALL(fmi3SetFMUState)(cart.unit, state) == fmi3OK);
  cart.run(10, 50);
  CHECK(cart.get(position) == first);
  fmi3FMUState copy = nullptr;
  REQUIRE(CALL(fmi3DeserializeFMUState)(other.unit, bytes.data(), size, &copy) == fmi3OK);
  REQUIRE(CALL(fmi3SetFMUState)(other.unit, copy) == fmi3OK);
  other.run(10, 50);
  CHECK(other.get(position) == first);
  Unit exchange(true);
  exchange.initialize();
  CHECK(CALL(fmi3SetFMUState)(exchange.unit, state) == fmi3Error);
  CHECK(CALL(fmi3FreeFMUState)(cart.unit, &state) == fmi3OK);
  CHECK(CALL(fmi3FreeFMUState)(other.unit, &copy) == fmi3OK);
  CHECK(copy == nullptr);
}

TEST_CASE("a run may begin at any tick, and at no time between two", "[full]") {
  if (!there_is_a_compiler()) return;
  Unit cart;
  CHECK(CALL(fmi3EnterInitializationMode)(cart.unit, false, 0.0, 0.505, false, 0.0) == fmi3Error);
  CHECK_THAT(cart.message, Contains("cannot begin at 0.505 s"));
  CHECK(CALL(fmi3EnterInitializationMode)(cart.unit, false, 0.0, 1e300, false, 0.0) == fmi3Error);
  CHECK_THAT(cart.message, Contains("cannot begin at 1e+300 s"));
  REQUIRE(CALL(fmi3EnterInitializationMode)(cart.unit, false, 0.0, 0.5, false, 0.0) == fmi3OK);
  REQUIRE(CALL(fmi3ExitInitializationMode)(cart.unit) == fmi3OK);
  CHECK(cart.get(time_) == 0.5);
  CHECK(cart.step(0.0) == fmi3Error);
  CHECK(cart.step(0.5) == fmi3OK);
  CHECK(cart.get(time_) == 0.51);
}

TEST_CASE("directional derivatives are those of the equations", "[full]") {
  if (!there_is_a_compiler()) return;
  Unit cart(true);
  cart.initialize();
  REQUIRE(CALL(fmi3EnterContinuousTimeMode)(cart.unit) == fmi3OK);
  const fmi3ValueReference unknowns[] = {velocity + 1, net, both}, knowns[] = {push, position};
  const double along_push[] = {1.0, 0.0}, along_position[] = {0.0, 2.0};
  double change[4];
  auto* const derivative = CALL(fmi3GetDirectionalDerivative);
  REQUIRE(derivative(cart.unit, unknowns, 3, knowns, 2, along_push, 2, change, 4) == fmi3OK);
  CHECK(change[0] == Approx(1.0 / 2.0));  // by the mass
  CHECK(change[1] == Approx(1.0));
  CHECK(change[2] == Approx(1.0));
  CHECK(change[3] == Approx(1.0));
  REQUIRE(derivative(cart.unit, unknowns, 3, knowns, 2, along_position, 2, change, 4) == fmi3OK);
  CHECK(change[0] == Approx(2.0 * -8.0 / 2.0));
  CHECK(change[1] == Approx(-16.0));
  CHECK(change[2] == Approx(0.0).margin(1e-6));
  CHECK(derivative(cart.unit, unknowns, 3, knowns, 2, along_push, 2, change, 3) == fmi3Error);
}

}  // namespace stepwire::fmu
