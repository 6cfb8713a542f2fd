// A unit of FMI 3 and 2 that does one thing wrong in one of its calls: its token has both, "exit DoStep". Its
// output is its present time; it has one event indicator and time events. With "end" it requests the end of
// the run instead. From then on its output is higher by 100, and a further call is an error. With "early" it
// does so at 0.25 s, in the middle of a step.
#include <unistd.h>
#include <xmmintrin.h>

#include <cfenv>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <string>

#include "engine/base/fmi/fmi2.h"
#include "engine/base/fmi/fmi3.h"

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity(),
                 nan = std::numeric_limits<double>::quiet_NaN();
constexpr double begins = 0.25;  // [s] of what is wrong in a run

struct Unit {
  std::string deed, call;
  double time = 0.0;
  bool over = false;  ///< true once it has terminated the simulation

  double output() const { return over ? time + 100.0 : time; }
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
  if (unit.over) return call == "Get" || call == "FreeInstance" ? 0 : 3;
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
  if (unit.does("beyond")) return right + 0.002;
  if (unit.does("far")) return right + 0.02;
  return right;
}

Unit& of(void* unit) {
  return *static_cast<Unit*>(unit);
}

/// Terminates the simulation in this call, once it is time; true where it does.
bool ends(Unit& unit, const std::string& call) {
  const double since = call == "Start" ? 0.0 : begins;
  const bool asks =
      (unit.does("end") || unit.does("early")) && unit.call == call && unit.time >= since && !unit.over;
  unit.over = unit.over || asks;
  return asks;
}

int step(Unit& unit, double end) {
  if (unit.over) return 3;
  unit.time = unit.does("early") ? std::fmin(end, begins) : end;
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
#define RETURNS_3(status, name, ...)           \
  fmi3Status name(fmi3Instance, __VA_ARGS__) { \
    return status;                             \
  }
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
#undef ALWAYS
fmi3Status fmi3EnterEventMode(fmi3Instance unit) {
  return static_cast<fmi3Status>(act(of(unit), "Mode"));
}
fmi3Status fmi3EnterContinuousTimeMode(fmi3Instance unit) {
  return static_cast<fmi3Status>(act(of(unit), "Mode"));
}
#define VALUES(Type)                                                                                       \
  fmi3Status fmi3Get##Type(fmi3Instance unit, const fmi3ValueReference[], size_t, fmi3##Type values[],     \
                           size_t n) {                                                                     \
    for (size_t i = 0; i < n; ++i) values[i] = static_cast<fmi3##Type>(of(unit).output());                 \
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
RETURNS_3(fmi3Error, fmi3GetFMUState, fmi3FMUState*)
RETURNS_3(fmi3Error, fmi3SetFMUState, fmi3FMUState)
RETURNS_3(fmi3Error, fmi3FreeFMUState, fmi3FMUState*)
RETURNS_3(fmi3Error, fmi3SerializedFMUStateSize, fmi3FMUState, size_t*)
RETURNS_3(fmi3Error, fmi3SerializeFMUState, fmi3FMUState, fmi3Byte[], size_t)
RETURNS_3(fmi3Error, fmi3DeserializeFMUState, const fmi3Byte[], size_t, fmi3FMUState*)
fmi3Status fmi3SetTime(fmi3Instance unit, fmi3Float64 time) {
  of(unit).time = time;
  return static_cast<fmi3Status>(act(of(unit), "SetTime"));
}
RETURNS_3(fmi3OK, fmi3SetContinuousStates, const fmi3Float64[], size_t)
RETURNS_3(fmi3OK, fmi3GetContinuousStates, fmi3Float64[], size_t)
RETURNS_3(fmi3OK, fmi3GetContinuousStateDerivatives, fmi3Float64[], size_t)
fmi3Status fmi3GetEventIndicators(fmi3Instance unit, fmi3Float64 indicators[], size_t) {
  indicators[0] = indicator_of(of(unit));
  return static_cast<fmi3Status>(act(of(unit), "Indicators"));
}
fmi3Status fmi3CompletedIntegratorStep(fmi3Instance unit, fmi3Boolean, fmi3Boolean* event, fmi3Boolean* end) {
  const int status = act(of(unit), "CompletedStep");
  *event = false;
  *end = ends(of(unit), "CompletedStep");
  return static_cast<fmi3Status>(status);
}
fmi3Status fmi3UpdateDiscreteStates(fmi3Instance unit, fmi3Boolean* again, fmi3Boolean* end,
                                    fmi3Boolean* nominals, fmi3Boolean* changed, fmi3Boolean* has_next,
                                    fmi3Float64* next) {
  *again = *end = *nominals = *changed = false;
  *has_next = true;
  *next = next_of(of(unit));
  const int status = act(of(unit), "Update");
  *end = ends(of(unit), of(unit).time == 0.0 ? "Start" : "Update");
  return static_cast<fmi3Status>(status);
}
fmi3Status fmi3DoStep(fmi3Instance unit, fmi3Float64 time, fmi3Float64 length, fmi3Boolean,
                      fmi3Boolean* event, fmi3Boolean* end, fmi3Boolean* early, fmi3Float64* last) {
  *event = *end = *early = false;
  const int status = step(of(unit), time + length);
  *end = ends(of(unit), "DoStep");
  *early = of(unit).time < time + length;
  *last = of(unit).call == "DoStep" ? told(of(unit), of(unit).time) : time + length;
  return static_cast<fmi3Status>(status);
}

// --- FMI 2
#define RETURNS_2(status, name, ...)            \
  fmi2Status name(fmi2Component, __VA_ARGS__) { \
    return status;                              \
  }
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
#undef ALWAYS
fmi2Status fmi2EnterEventMode(fmi2Component unit) {
  return static_cast<fmi2Status>(act(of(unit), "Mode"));
}
fmi2Status fmi2EnterContinuousTimeMode(fmi2Component unit) {
  return static_cast<fmi2Status>(act(of(unit), "Mode"));
}
#define VALUES(Type)                                                                                        \
  fmi2Status fmi2Get##Type(fmi2Component unit, const fmi2ValueReference[], size_t n, fmi2##Type values[]) { \
    for (size_t i = 0; i < n; ++i) values[i] = static_cast<fmi2##Type>(of(unit).output());                  \
    return static_cast<fmi2Status>(act(of(unit), "Get"));                                                   \
  }                                                                                                         \
  fmi2Status fmi2Set##Type(fmi2Component, const fmi2ValueReference[], size_t, const fmi2##Type[]) {         \
    return fmi2OK;                                                                                          \
  }
VALUES(Real)
VALUES(Integer)
VALUES(Boolean)
#undef VALUES
RETURNS_2(fmi2Error, fmi2GetFMUstate, fmi2FMUstate*)
RETURNS_2(fmi2Error, fmi2SetFMUstate, fmi2FMUstate)
RETURNS_2(fmi2Error, fmi2FreeFMUstate, fmi2FMUstate*)
RETURNS_2(fmi2Error, fmi2SerializedFMUstateSize, fmi2FMUstate, size_t*)
RETURNS_2(fmi2Error, fmi2SerializeFMUstate, fmi2FMUstate, fmi2Byte[], size_t)
RETURNS_2(fmi2Error, fmi2DeSerializeFMUstate, const fmi2Byte[], size_t, fmi2FMUstate*)
fmi2Status fmi2SetTime(fmi2Component unit, fmi2Real time) {
  of(unit).time = time;
  return static_cast<fmi2Status>(act(of(unit), "SetTime"));
}
RETURNS_2(fmi2OK, fmi2SetContinuousStates, const fmi2Real[], size_t)
RETURNS_2(fmi2OK, fmi2GetContinuousStates, fmi2Real[], size_t)
RETURNS_2(fmi2OK, fmi2GetDerivatives, fmi2Real[], size_t)
fmi2Status fmi2GetEventIndicators(fmi2Component unit, fmi2Real indicators[], size_t) {
  indicators[0] = indicator_of(of(unit));
  return static_cast<fmi2Status>(act(of(unit), "Indicators"));
}
fmi2Status fmi2CompletedIntegratorStep(fmi2Component unit, fmi2Boolean, fmi2Boolean* event,
                                       fmi2Boolean* end) {
  const int status = act(of(unit), "CompletedStep");
  *event = fmi2False;
  *end = ends(of(unit), "CompletedStep");
  return static_cast<fmi2Status>(status);
}
fmi2Status fmi2NewDiscreteStates(fmi2Component unit, fmi2EventInfo* info) {
  const int status = act(of(unit), "Update");
  const fmi2Boolean end = ends(of(unit), of(unit).time == 0.0 ? "Start" : "Update") ? fmi2True : fmi2False;
  *info = {fmi2False, end, fmi2False, fmi2False, fmi2True, next_of(of(unit))};
  return static_cast<fmi2Status>(status);
}
fmi2Status fmi2DoStep(fmi2Component unit, fmi2Real time, fmi2Real length, fmi2Boolean) {
  const int status = step(of(unit), time + length);
  return ends(of(unit), "DoStep") ? fmi2Discard : static_cast<fmi2Status>(status);
}
fmi2Status fmi2GetBooleanStatus(fmi2Component unit, const fmi2StatusKind, fmi2Boolean* value) {
  *value = fmi2True;
  return of(unit).over ? fmi2OK : fmi2Error;
}
fmi2Status fmi2GetRealStatus(fmi2Component unit, const fmi2StatusKind, fmi2Real* value) {
  *value = of(unit).time;
  return of(unit).over ? fmi2OK : fmi2Error;
}
}
