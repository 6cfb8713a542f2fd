// A unit of FMI 3 and 2 that does one thing wrong in one of its calls: its token has both, "exit DoStep". Its
// output is the time that it has reached; it has one event indicator and events by time.
#include <unistd.h>
#include <xmmintrin.h>

#include <cfenv>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <string>

#include "engine/base/fmi/fmi2_unit.h"
#include "engine/base/fmi/fmi3.h"

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity(),
                 nan = std::numeric_limits<double>::quiet_NaN();
constexpr double begins = 0.25;  // [s] of what is wrong in a run

struct Unit {
  std::string deed, call;
  double time = 0.0;

  bool does(const char* what) const { return deed == what; }
};

void hang() {
  while (true) ::pause();
}

int status_of(const std::string& deed) {
  return deed.starts_with("status") ? std::atoi(deed.c_str() + 6) : 0;
}

/// Does the deed where this is its call and its time; returns the status of the call.
int act(const Unit& unit, const std::string& call) {
  const bool runs = call == "DoStep" || call == "Get";
  if (unit.call != call || (runs && unit.time < begins)) return 0;
  if (unit.does("exit")) std::exit(0);
  if (unit.does("quick_exit")) std::quick_exit(0);
  if (unit.does("_exit")) ::_exit(0);
  if (unit.does("hang")) hang();
  if (unit.does("stop")) std::raise(SIGSTOP);
  if (unit.does("throw")) throw 1;
  if (unit.does("upward")) std::fesetround(FE_UPWARD);
  if (unit.does("print")) std::printf("printed\n"), std::fflush(stdout);
  if (unit.does("chdir") && ::chdir("/") != 0) std::abort();
  if (unit.does("fork") && ::fork() == 0) hang();
  if (unit.does("flush")) _mm_setcsr(_mm_getcsr() | 0x8040u);
  return status_of(unit.deed);
}

Unit* make(const char* token) {
  const std::string words = token;
  const std::size_t space = words.find(' ');
  auto* unit = new Unit{words.substr(0, space), words.substr(space + 1)};
  act(*unit, "Instantiate");
  return unit;
}

void free_unit(void* instance) {
  auto* unit = static_cast<Unit*>(instance);
  act(*unit, "FreeInstance");
  delete unit;
}

/// A number that is wrong once it is time.
double told(const Unit& unit, double right) {
  if (unit.time < begins) return right;
  if (unit.does("nan")) return nan;
  if (unit.does("infinite")) return infinite;
  if (unit.does("backwards")) return -1.0;
  return right;
}

Unit& of(void* unit) {
  return *static_cast<Unit*>(unit);
}

int step(Unit& unit, double end) {
  unit.time = end;
  return act(unit, "DoStep");
}

double next_of(const Unit& unit) {
  const double next = std::floor(unit.time * 10.0 + 1.5) / 10.0;
  return unit.call == "Update" ? told(unit, next) : next;
}

double indicator_of(const Unit& unit) {
  return unit.call == "GetEventIndicators" ? told(unit, 1.0) : 1.0;
}

}  // namespace

extern "C" {

// --- FMI 3
fmi3Instance fmi3InstantiateModelExchange(fmi3String, fmi3String token, fmi3String, fmi3Boolean, fmi3Boolean,
                                          fmi3InstanceEnvironment, fmi3LogMessageCallback) {
  return make(token);
}
fmi3Instance fmi3InstantiateCoSimulation(fmi3String, fmi3String token, fmi3String, fmi3Boolean, fmi3Boolean,
                                         fmi3Boolean, fmi3Boolean, const fmi3ValueReference[], size_t,
                                         fmi3InstanceEnvironment, fmi3LogMessageCallback,
                                         fmi3IntermediateUpdateCallback) {
  return make(token);
}
void fmi3FreeInstance(fmi3Instance unit) {
  free_unit(unit);
}
fmi3Status fmi3EnterInitializationMode(fmi3Instance unit, fmi3Boolean, fmi3Float64, fmi3Float64 start,
                                       fmi3Boolean, fmi3Float64) {
  of(unit).time = start;
  return static_cast<fmi3Status>(act(of(unit), "Initialize"));
}
#define ALWAYS(name)              \
  fmi3Status name(fmi3Instance) { \
    return fmi3OK;                \
  }
ALWAYS(fmi3ExitInitializationMode)
ALWAYS(fmi3Terminate)
ALWAYS(fmi3EnterEventMode)
ALWAYS(fmi3EnterContinuousTimeMode)
#undef ALWAYS
#define VALUES(Type)                                                                                       \
  fmi3Status fmi3Get##Type(fmi3Instance unit, const fmi3ValueReference[], size_t, fmi3##Type values[],     \
                           size_t n) {                                                                     \
    for (size_t i = 0; i < n; ++i) values[i] = static_cast<fmi3##Type>(of(unit).time);                     \
    return static_cast<fmi3Status>(act(of(unit), "Get"));                                                  \
  }                                                                                                        \
  fmi3Status fmi3Set##Type(fmi3Instance, const fmi3ValueReference[], size_t, const fmi3##Type[], size_t) { \
    return fmi3OK;                                                                                         \
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
fmi3Status fmi3GetFMUState(fmi3Instance, fmi3FMUState*) {
  return fmi3Error;
}
fmi3Status fmi3SetFMUState(fmi3Instance, fmi3FMUState) {
  return fmi3Error;
}
fmi3Status fmi3FreeFMUState(fmi3Instance, fmi3FMUState*) {
  return fmi3Error;
}
fmi3Status fmi3SerializedFMUStateSize(fmi3Instance, fmi3FMUState, size_t*) {
  return fmi3Error;
}
fmi3Status fmi3SerializeFMUState(fmi3Instance, fmi3FMUState, fmi3Byte[], size_t) {
  return fmi3Error;
}
fmi3Status fmi3DeserializeFMUState(fmi3Instance, const fmi3Byte[], size_t, fmi3FMUState*) {
  return fmi3Error;
}
fmi3Status fmi3SetTime(fmi3Instance unit, fmi3Float64 time) {
  of(unit).time = time;
  return fmi3OK;
}
fmi3Status fmi3SetContinuousStates(fmi3Instance, const fmi3Float64[], size_t) {
  return fmi3OK;
}
fmi3Status fmi3GetContinuousStates(fmi3Instance, fmi3Float64[], size_t) {
  return fmi3OK;
}
fmi3Status fmi3GetContinuousStateDerivatives(fmi3Instance, fmi3Float64[], size_t) {
  return fmi3OK;
}
fmi3Status fmi3GetEventIndicators(fmi3Instance unit, fmi3Float64 indicators[], size_t) {
  indicators[0] = indicator_of(of(unit));
  return fmi3OK;
}
fmi3Status fmi3CompletedIntegratorStep(fmi3Instance, fmi3Boolean, fmi3Boolean* event, fmi3Boolean* end) {
  *event = *end = false;
  return fmi3OK;
}
fmi3Status fmi3UpdateDiscreteStates(fmi3Instance unit, fmi3Boolean* again, fmi3Boolean* end,
                                    fmi3Boolean* nominals, fmi3Boolean* changed, fmi3Boolean* has_next,
                                    fmi3Float64* next) {
  *again = *end = *nominals = *changed = false;
  *has_next = true;
  *next = next_of(of(unit));
  return static_cast<fmi3Status>(act(of(unit), "Update"));
}
fmi3Status fmi3DoStep(fmi3Instance unit, fmi3Float64 time, fmi3Float64 length, fmi3Boolean,
                      fmi3Boolean* event, fmi3Boolean* end, fmi3Boolean* early, fmi3Float64* last) {
  *event = *end = *early = false;
  const int status = step(of(unit), time + length);
  *last = of(unit).call == "DoStep" ? told(of(unit), time + length) : time + length;
  return static_cast<fmi3Status>(status);
}

// --- FMI 2
fmi2Component fmi2Instantiate(fmi2String, fmi2Type, fmi2String token, fmi2String,
                              const fmi2CallbackFunctions*, fmi2Boolean, fmi2Boolean) {
  return make(token);
}
void fmi2FreeInstance(fmi2Component unit) {
  free_unit(unit);
}
fmi2Status fmi2SetupExperiment(fmi2Component unit, fmi2Boolean, fmi2Real, fmi2Real start, fmi2Boolean,
                               fmi2Real) {
  of(unit).time = start;
  return static_cast<fmi2Status>(act(of(unit), "Initialize"));
}
#define ALWAYS(name)               \
  fmi2Status name(fmi2Component) { \
    return fmi2OK;                 \
  }
ALWAYS(fmi2EnterInitializationMode)
ALWAYS(fmi2ExitInitializationMode)
ALWAYS(fmi2Terminate)
ALWAYS(fmi2EnterEventMode)
ALWAYS(fmi2EnterContinuousTimeMode)
#undef ALWAYS
#define VALUES(Type)                                                                                        \
  fmi2Status fmi2Get##Type(fmi2Component unit, const fmi2ValueReference[], size_t n, fmi2##Type values[]) { \
    for (size_t i = 0; i < n; ++i) values[i] = static_cast<fmi2##Type>(of(unit).time);                      \
    return static_cast<fmi2Status>(act(of(unit), "Get"));                                                   \
  }                                                                                                         \
  fmi2Status fmi2Set##Type(fmi2Component, const fmi2ValueReference[], size_t, const fmi2##Type[]) {         \
    return fmi2OK;                                                                                          \
  }
VALUES(Real)
VALUES(Integer)
VALUES(Boolean)
#undef VALUES
fmi2Status fmi2GetFMUstate(fmi2Component, fmi2FMUstate*) {
  return fmi2Error;
}
fmi2Status fmi2SetFMUstate(fmi2Component, fmi2FMUstate) {
  return fmi2Error;
}
fmi2Status fmi2FreeFMUstate(fmi2Component, fmi2FMUstate*) {
  return fmi2Error;
}
fmi2Status fmi2SerializedFMUstateSize(fmi2Component, fmi2FMUstate, size_t*) {
  return fmi2Error;
}
fmi2Status fmi2SerializeFMUstate(fmi2Component, fmi2FMUstate, fmi2Byte[], size_t) {
  return fmi2Error;
}
fmi2Status fmi2DeSerializeFMUstate(fmi2Component, const fmi2Byte[], size_t, fmi2FMUstate*) {
  return fmi2Error;
}
fmi2Status fmi2SetTime(fmi2Component unit, fmi2Real time) {
  of(unit).time = time;
  return fmi2OK;
}
fmi2Status fmi2SetContinuousStates(fmi2Component, const fmi2Real[], size_t) {
  return fmi2OK;
}
fmi2Status fmi2GetContinuousStates(fmi2Component, fmi2Real[], size_t) {
  return fmi2OK;
}
fmi2Status fmi2GetDerivatives(fmi2Component, fmi2Real[], size_t) {
  return fmi2OK;
}
fmi2Status fmi2GetEventIndicators(fmi2Component unit, fmi2Real indicators[], size_t) {
  indicators[0] = indicator_of(of(unit));
  return fmi2OK;
}
fmi2Status fmi2CompletedIntegratorStep(fmi2Component, fmi2Boolean, fmi2Boolean* event, fmi2Boolean* end) {
  *event = *end = fmi2False;
  return fmi2OK;
}
fmi2Status fmi2NewDiscreteStates(fmi2Component unit, fmi2EventInfo* info) {
  *info = {fmi2False, fmi2False, fmi2False, fmi2False, fmi2True, next_of(of(unit))};
  return static_cast<fmi2Status>(act(of(unit), "Update"));
}
fmi2Status fmi2DoStep(fmi2Component unit, fmi2Real time, fmi2Real length, fmi2Boolean) {
  return static_cast<fmi2Status>(step(of(unit), time + length));
}
fmi2Status fmi2GetBooleanStatus(fmi2Component, const fmi2StatusKind, fmi2Boolean*) {
  return fmi2Error;
}
}
