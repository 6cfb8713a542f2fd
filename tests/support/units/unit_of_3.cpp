// Small units of FMI 3 for tests, all in one binary; the instantiation token selects one.
#include <cmath>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <string>

#include "engine/base/fmi/fmi3.h"

namespace {

/// Values by their references: the numbers of the descriptions in units.cpp.
struct Unit {
  std::string kind;
  double time = 0.0;
  double v[32] = {};  // as plain bytes: what is saved and restored
  fmi3InstanceEnvironment environment;
  fmi3LogMessageCallback log;

  bool is(const char* name) const { return kind == name; }
};

Unit& of(fmi3Instance unit) {
  return *static_cast<Unit*>(unit);
}

fmi3Instance make(fmi3String token, fmi3InstanceEnvironment environment, fmi3LogMessageCallback log) {
  auto* unit = new Unit;
  unit->kind = token;
  unit->environment = environment;
  unit->log = log;
  if (unit->is("dahlquist")) unit->v[1] = 1.0, unit->v[3] = 1.0;
  if (unit->is("ball")) unit->v[1] = 1.0, unit->v[4] = -9.81, unit->v[5] = 0.7, unit->v[6] = 0.1;
  const char* kinds[] = {"dahlquist", "ball", "feedthrough", "stair", "fails", "crashes"};
  for (const char* kind : kinds)
    if (unit->is(kind)) return unit;
  log(environment, fmi3Error, "token", "the token is another one");
  delete unit;
  return nullptr;
}

void bounce(Unit& unit) {
  if (unit.v[1] > 0.0 || unit.v[3] >= 0.0) return;
  unit.v[1] = 2.2250738585072014e-308;
  unit.v[3] *= -unit.v[5];
  if (unit.v[3] < unit.v[6]) unit.v[3] = 0.0, unit.v[4] = 0.0;
}

void euler(Unit& unit, double h) {
  if (unit.is("dahlquist")) unit.v[1] += h * (-unit.v[3] * unit.v[1]);
  if (unit.is("ball")) {
    const double v = unit.v[3];
    unit.v[1] += h * v;
    unit.v[3] += h * unit.v[4];
    bounce(unit);
  }
}

}  // namespace

extern "C" {

const char* fmi3GetVersion(void) {
  return "3.0";
}
fmi3Instance fmi3InstantiateModelExchange(fmi3String, fmi3String token, fmi3String, fmi3Boolean, fmi3Boolean,
                                          fmi3InstanceEnvironment environment, fmi3LogMessageCallback log) {
  return make(token, environment, log);
}
fmi3Instance fmi3InstantiateCoSimulation(fmi3String, fmi3String token, fmi3String, fmi3Boolean, fmi3Boolean,
                                         fmi3Boolean, fmi3Boolean, const fmi3ValueReference[], size_t,
                                         fmi3InstanceEnvironment environment, fmi3LogMessageCallback log,
                                         fmi3IntermediateUpdateCallback) {
  return make(token, environment, log);
}
void fmi3FreeInstance(fmi3Instance unit) {
  delete static_cast<Unit*>(unit);
}
fmi3Status fmi3EnterInitializationMode(fmi3Instance unit, fmi3Boolean, fmi3Float64, fmi3Float64 start,
                                       fmi3Boolean, fmi3Float64) {
  of(unit).time = start;
  if (of(unit).is("stair")) of(unit).v[1] = 1.0, of(unit).v[2] = 1.0;
  return fmi3OK;
}
fmi3Status fmi3ExitInitializationMode(fmi3Instance) {
  return fmi3OK;
}
fmi3Status fmi3Terminate(fmi3Instance) {
  return fmi3OK;
}

// Every value is kept as a number.
#define VALUES(Type)                                                                                        \
  fmi3Status fmi3Get##Type(fmi3Instance unit, const fmi3ValueReference r[], size_t count,                   \
                           fmi3##Type values[], size_t) {                                                   \
    for (size_t i = 0; i < count; ++i)                                                                      \
      values[i] = static_cast<fmi3##Type>(of(unit).is("ball") && r[i] == 2 ? of(unit).v[3] : of(unit).v[r[i]]); \
    return fmi3OK;                                                                                          \
  }                                                                                                         \
  fmi3Status fmi3Set##Type(fmi3Instance unit, const fmi3ValueReference r[], size_t count,                   \
                           const fmi3##Type values[], size_t) {                                             \
    for (size_t i = 0; i < count; ++i) of(unit).v[r[i]] = static_cast<double>(values[i]);                   \
    return fmi3OK;                                                                                          \
  }
VALUES(Float64)
VALUES(Float32)
VALUES(Int8)
VALUES(UInt8)
VALUES(Int16)
VALUES(UInt16)
VALUES(Int32)
VALUES(UInt32)
VALUES(Int64)
VALUES(UInt64)
VALUES(Boolean)
#undef VALUES

fmi3Status fmi3GetFMUState(fmi3Instance unit, fmi3FMUState* state) {
  *state = std::malloc(sizeof of(unit).v);
  std::memcpy(*state, of(unit).v, sizeof of(unit).v);
  return fmi3OK;
}
fmi3Status fmi3SetFMUState(fmi3Instance unit, fmi3FMUState state) {
  std::memcpy(of(unit).v, state, sizeof of(unit).v);
  return fmi3OK;
}
fmi3Status fmi3FreeFMUState(fmi3Instance, fmi3FMUState* state) {
  std::free(*state);
  *state = nullptr;
  return fmi3OK;
}
fmi3Status fmi3SerializedFMUStateSize(fmi3Instance unit, fmi3FMUState, size_t* size) {
  *size = sizeof of(unit).v;
  return fmi3OK;
}
fmi3Status fmi3SerializeFMUState(fmi3Instance, fmi3FMUState state, fmi3Byte bytes[], size_t size) {
  std::memcpy(bytes, state, size);
  return fmi3OK;
}
fmi3Status fmi3DeserializeFMUState(fmi3Instance, const fmi3Byte bytes[], size_t size, fmi3FMUState* state) {
  *state = std::malloc(size);
  std::memcpy(*state, bytes, size);
  return fmi3OK;
}

fmi3Status fmi3SetTime(fmi3Instance unit, fmi3Float64 time) {
  of(unit).time = time;
  return fmi3OK;
}
fmi3Status fmi3SetContinuousStates(fmi3Instance unit, const fmi3Float64 states[], size_t count) {
  for (size_t i = 0; i < count; ++i) of(unit).v[1 + 2 * i] = states[i];
  return fmi3OK;
}
fmi3Status fmi3GetContinuousStates(fmi3Instance unit, fmi3Float64 states[], size_t count) {
  for (size_t i = 0; i < count; ++i) states[i] = of(unit).v[1 + 2 * i];
  return fmi3OK;
}
fmi3Status fmi3GetContinuousStateDerivatives(fmi3Instance unit, fmi3Float64 slopes[], size_t) {
  const double* v = of(unit).v;
  if (of(unit).is("dahlquist")) slopes[0] = -v[3] * v[1];
  if (of(unit).is("ball")) slopes[0] = v[3], slopes[1] = v[4];
  return fmi3OK;
}
fmi3Status fmi3GetEventIndicators(fmi3Instance unit, fmi3Float64 indicators[], size_t) {
  indicators[0] = of(unit).v[1] == 0.0 && of(unit).v[3] == 0.0 ? 1.0 : of(unit).v[1];
  return fmi3OK;
}
fmi3Status fmi3CompletedIntegratorStep(fmi3Instance, fmi3Boolean, fmi3Boolean* event, fmi3Boolean* end) {
  *event = *end = false;
  return fmi3OK;
}
fmi3Status fmi3EnterEventMode(fmi3Instance) {
  return fmi3OK;
}
fmi3Status fmi3UpdateDiscreteStates(fmi3Instance instance, fmi3Boolean* again, fmi3Boolean* end,
                                    fmi3Boolean* nominals, fmi3Boolean* changed, fmi3Boolean* has_next,
                                    fmi3Float64* next) {
  Unit& unit = of(instance);
  *again = *end = *nominals = *changed = *has_next = false;
  if (unit.is("ball") && unit.v[1] <= 0.0 && unit.v[3] < 0.0) {
    bounce(unit);
    *changed = true;
  }
  if (unit.is("stair")) {
    if (unit.time >= unit.v[2]) unit.v[1] += 1.0, unit.v[2] += 1.0;
    *has_next = true;
    *next = unit.v[2];
  }
  return fmi3OK;
}
fmi3Status fmi3EnterContinuousTimeMode(fmi3Instance) {
  return fmi3OK;
}

fmi3Status fmi3DoStep(fmi3Instance instance, fmi3Float64 time, fmi3Float64 length, fmi3Boolean,
                      fmi3Boolean* event, fmi3Boolean* end, fmi3Boolean* early, fmi3Float64* last) {
  Unit& unit = of(instance);
  *event = *end = *early = false;
  *last = time + length;
  const double own = unit.is("dahlquist") ? 0.1 : 1e-3;
  for (long i = std::lround(length / own); i > 0; --i) euler(unit, own);
  for (int i = 1; i <= 11 && unit.is("feedthrough"); ++i) unit.v[11 + i] = unit.v[i];
  if (unit.is("fails") && time + length > 0.25) {
    unit.log(unit.environment, fmi3Error, "step", "the spring has broken");
    return fmi3Error;
  }
  if (unit.is("crashes") && time + length > 0.25) std::raise(SIGSEGV);
  return fmi3OK;
}
}
