// Branches of a unit of model exchange: an importer's solver never sees both sides of an event.
#include <catch2/catch.hpp>
#include <cmath>
#include <string>

#include "engine/base/fmi/fmi3.h"
#include "tests/engine/app/fmu/exported.hpp"
#include "tests/support/run_text.hpp"

namespace stepwire::fmu {

namespace {

// x falls by 1 1/s from 1 to 0.5, then by 3 1/s. From 0.53 s on it falls by 2 1/s more.
const char* const falls = R"(stepwire: 1
title: a fall in three stages
step: 10 ms
stop: 1 s
solver: rk4
events: locate
blocks:
  rate:  {block: Expression, expression: "u1 > 0.5 ? -1 : -3", u: x}
  more:  {block: Step, time: 0.53 s, before: 0, after: -2}
  slope: {block: Sum, u: [rate, more]}
  x:     {block: Integrator, u: slope, initial: 1}
record: [x]
)";

/// An instance at time 0 in continuous-time mode.
class Unit {
 public:
  Unit() {
    unit_ = call<decltype(fmi3InstantiateModelExchange)>("fmi3InstantiateModelExchange")(
        "a", binary().token().c_str(), "", false, false, nullptr, nullptr);
    REQUIRE(call<decltype(fmi3EnterInitializationMode)>("fmi3EnterInitializationMode")(unit_, false, 0.0, 0.0,
                                                                                       false, 0.0) == fmi3OK);
    REQUIRE(call<decltype(fmi3ExitInitializationMode)>("fmi3ExitInitializationMode")(unit_) == fmi3OK);
    leave_event();
  }
  ~Unit() { call<decltype(fmi3FreeInstance)>("fmi3FreeInstance")(unit_); }
  Unit(const Unit&) = delete;

  /// The derivative of x at a trial of the solver.
  double slope(double time, double x) const {
    double slope = NAN;
    CHECK(call<decltype(fmi3SetTime)>("fmi3SetTime")(unit_, time) == fmi3OK);
    CHECK(call<decltype(fmi3SetContinuousStates)>("fmi3SetContinuousStates")(unit_, &x, 1) == fmi3OK);
    CHECK(call<decltype(fmi3GetContinuousStateDerivatives)>("fmi3GetContinuousStateDerivatives")(
              unit_, &slope, 1) == fmi3OK);
    return slope;
  }

  void pass_event() {
    CHECK(call<decltype(fmi3EnterEventMode)>("fmi3EnterEventMode")(unit_) == fmi3OK);
    leave_event();
  }

 private:
  static const Binary& binary() {
    static const Binary one("falls", falls, 3);
    return one;
  }
  template <class Function>
  static Function* call(const char* name) {
    return binary().find<Function>(name);
  }

  void leave_event() {
    bool needs, ends, nominals, values, has_next;
    double next;
    CHECK(call<decltype(fmi3UpdateDiscreteStates)>("fmi3UpdateDiscreteStates")(
              unit_, &needs, &ends, &nominals, &values, &has_next, &next) == fmi3OK);
    CHECK(call<decltype(fmi3EnterContinuousTimeMode)>("fmi3EnterContinuousTimeMode")(unit_) == fmi3OK);
  }

  fmi3Instance unit_ = nullptr;
};

}  // namespace

TEST_CASE("a unit keeps its branch until the importer passes an event", "[full]") {
  if (!there_is_a_compiler()) return;
  const Unit unit;
  CHECK(unit.slope(0.3, 0.7) == -1.0);
  CHECK(unit.slope(0.6, 0.4) == -1.0);
}

TEST_CASE("a unit takes the branch of the event that the importer passes", "[full]") {
  if (!there_is_a_compiler()) return;
  Unit unit;
  CHECK(unit.slope(0.5001, 0.4999) == -1.0);
  unit.pass_event();
  CHECK(unit.slope(0.5001, 0.4999) == -3.0);
  CHECK(unit.slope(0.53, 0.41) == -3.0);  // before the jump of the source
  unit.pass_event();
  CHECK(unit.slope(0.53, 0.41) == -5.0);
}

TEST_CASE("an importing run has the error of its solver behind the events of a unit", "[full]") {
  if (!there_is_a_compiler()) return;
  const Scratch folder;
  const std::string path = exported(folder, "falls", falls, GENERATE(3, 2));
  const table::Table unit = run_text(
      "step: 40 ms\nstop: 1 s\nsolver: rk4\nevents: locate\nblocks:\n  unit: {block: Fmu, file: " + path +
      ", interface: model_exchange}\nrecord: [unit.x]\n");
  CHECK(column(unit, "unit.x")[15] == Approx(0.41 - 5 * 0.07).epsilon(1e-9));  // at 0.6 s
  CHECK(column(unit, "unit.x").back() == Approx(0.41 - 5 * 0.47).epsilon(1e-9));
}

}  // namespace stepwire::fmu
